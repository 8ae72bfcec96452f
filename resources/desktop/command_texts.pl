#!/usr/bin/env perl
# SPDX-License-Identifier: BSD-3-Clause
# command_texts.pl TEMPLATE OUT VERSION DATE DESCRIPTION …   writes OUT/palpate.1, OUT/palpate.bash and OUT/_palpate: the
# manual page, and the completions of bash and zsh. DESCRIPTION is what a program prints with --describe-commands
# (app/src/shared/CommandDescription.h). Commands without options of their own in one description are taken from the next
# ones: `palpate` knows no options of `evaluate`.
use strict;
use warnings;

die "usage: command_texts.pl TEMPLATE OUT VERSION DATE DESCRIPTION ...\n" if @ARGV < 5;
my ($template, $out, $version, $date, @descriptions) = @ARGV;

my (@paths, %text, %options);
for my $file (@descriptions) {
    open my $in, '<', $file or die "$file: $!\n";
    my (%found, %described);
    while (<$in>) {
        chomp;
        my ($kind, $path, @fields) = split /\t/, $_, -1;
        if ($kind eq 'command' && @fields == 1) {
            next if $path eq '' && %text; # the other program itself
            push @paths, $path unless exists $text{$path};
            $text{$path} = $fields[0];
            $described{$path} = 1;
        } elsif ($kind eq 'option' && @fields == 5) {
            push @{$found{$path}}, {names => [split /,/, $fields[0]], type => $fields[1], default => $fields[3],
                text => $fields[4], map { $_ => 1 } split /,/, $fields[2]} if $described{$path};
        } else {
            die "$file:$.: found \"$_\", expected a command or an option\n";
        }
    }
    for my $path (keys %found) {
        $options{$path} = $found{$path} if @{$found{$path}} > @{$options{$path} // []};
    }
}
die "found no commands\n" if @paths < 2;

sub positionals { return grep { $_->{names}[0] !~ /^-/ } @{$options{$_[0]} // []} }
sub switches { return grep { $_->{names}[0] =~ /^-/ } @{$options{$_[0]} // []} }
# The subcommands of a command, by their last word.
sub commands_of {
    my ($path) = @_;
    my $before = $path eq '' ? qr/^/ : qr/^\Q$path\E /;
    return map { /$before(\S+)$/ ? $1 : () } @paths;
}
# Most texts are names of files. Numbers with a unit are texts, too, which the program reads with the unit in its messages.
sub takes_file { return $_[0]{type} =~ /TEXT|PATH|FILE/ && $_[0]{text} !~ m{\[[A-Za-z/]+\]} }
sub value_name { return $_[0]{names}[0] =~ /^-/ ? ($_[0]{type} =~ /^(\w+)/)[0] : $_[0]{names}[0] }

sub write_file {
    my ($name, $content) = @_;
    open my $file, '>', "$out/$name" or die "$out/$name: $!\n";
    print $file $content;
    close $file or die "$out/$name: $!\n";
}

# --- manual page
sub roff {
    my ($text) = @_;
    $text =~ s/\\/\\e/g;
    $text =~ s/-/\\-/g;
    $text =~ s/^([.'])/\\&$1/gm;
    return $text;
}

sub roff_options {
    my ($path) = @_;
    my $page = '';
    for my $option (positionals($path), switches($path)) {
        my $head = $option->{names}[0] =~ /^-/
            ? join(', ', map { '\fB' . roff($_) . '\fR' } @{$option->{names}})
                . ($option->{type} ne '' ? ' \fI' . roff(value_name($option)) . '\fR' : '')
            : '\fI' . roff($option->{names}[0]) . '\fR';
        my $text = $option->{text};
        $text .= " (required)" if $option->{required} && $option->{names}[0] =~ /^-/;
        $text .= " [default: $option->{default}]" if $option->{default} ne '';
        $page .= ".TP\n$head" . ($option->{several} ? ' ...' : '') . "\n" . roff($text) . ".\n";
    }
    return $page;
}

my $page = do { local $/; open my $in, '<', $template or die "$template: $!\n"; <$in> };
my $commands = '';
for my $path (grep { $_ ne '' } @paths) {
    my $usage = join '', map {
        my $name = '\fI' . roff($_->{names}[0]) . '\fR' . ($_->{several} ? ' ...' : '');
        $_->{required} ? " $name" : " [$name]";
    } positionals($path);
    $usage = ' \fICOMMAND\fR' . $usage if commands_of($path);
    $commands .= ".SS \"palpate " . roff($path) . "\"\n.B palpate " . roff($path) . "\n[\\fIOPTION\\fR ...]$usage\n.PP\n"
        . roff($text{$path}) . ".\n" . roff_options($path);
}
$page =~ s/\@OPTIONS\@\n/roff_options('')/e;
$page =~ s/\@COMMANDS\@\n/$commands/;
$page =~ s/\@VERSION\@/roff($version)/ge;
$page =~ s/\@DATE\@/roff($date)/ge;
write_file('palpate.1', $page);

# --- bash
my $bash = <<'END';
# SPDX-License-Identifier: BSD-3-Clause
# Completion of bash for palpate. Written by command_texts.pl from the command line of the program.
_palpate()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} path='' word i
    local commands='' switches='' files='' values=''
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        case "$path:$word" in
END
for my $path (grep { commands_of($_) } @paths) {
    $bash .= "            " . join(' | ', map { "'$path:$_'" } commands_of($path)) . ")\n                path="
        . ($path eq '' ? '$word' : "'$path '\$word") . " ;;\n";
}
$bash .= "        esac\n    done\n    case \$path in\n";
for my $path (@paths) {
    my @values = grep { $_->{type} ne '' } switches($path);
    my $names = sub { return join ' ', map { @{$_->{names}} } @_ };
    $bash .= "        '$path')\n            commands='" . join(' ', commands_of($path)) . "'\n            switches='"
        . $names->(switches($path)) . "'\n            files=' " . $names->(grep { takes_file($_) } @values)
        . " '\n            values=' " . $names->(grep { !takes_file($_) } @values) . " ' ;;\n";
}
$bash .= <<'END';
    esac
    COMPREPLY=()
    if [[ $values == *" $previous "* ]]; then
        return # a number
    elif [[ $files == *" $previous "* ]]; then
        commands=''
    elif [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$switches" -- "$current")
        return
    fi
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current"; compgen -f -- "$current")
}
complete -F _palpate palpate
END
write_file('palpate.bash', $bash);

# --- zsh
sub quoted { my ($text) = @_; $text =~ s/'/'\\''/g; return "'$text'" }
sub zsh_text { my ($text) = @_; $text =~ s/([\[\]:\\])/\\$1/g; return $text }

my $zsh = <<'END';
#compdef palpate
# SPDX-License-Identifier: BSD-3-Clause
# Completion of zsh for palpate. Written by command_texts.pl from the command line of the program.
END
for my $path (reverse @paths) {
    (my $function = "_palpate_$path") =~ s/[ _]+$//;
    $function =~ s/ /_/g;
    my @commands = commands_of($path);
    $zsh .= "\n$function() {\n";
    if (@commands) {
        $zsh .= "  local -a commands=(\n"
            . join('', map { '    ' . quoted("$_:" . zsh_text($text{$path eq '' ? $_ : "$path $_"})) . "\n" } @commands)
            . "  )\n  case \$words[2] in\n    (" . join('|', @commands) . ")\n      if (( CURRENT > 2 )); then\n"
            . "        local command=\$words[2]\n        shift words\n        (( CURRENT-- ))\n"
            . "        ${function}_\$command\n        return\n      fi\n  esac\n";
    }
    $zsh .= "  _arguments -S \\\n";
    for my $option (switches($path)) {
        for my $name (@{$option->{names}}) {
            my $value = $option->{type} eq '' ? '' : ':' . value_name($option) . ':' . (takes_file($option) ? '_files' : ' ');
            $zsh .= '    ' . quoted(($option->{several} ? '*' : '') . $name . '[' . zsh_text($option->{text}) . ']' . $value) . " \\\n";
        }
    }
    $zsh .= @commands
        ? '    ' . quoted('*: :{ (( CURRENT == 2 )) && _describe command commands; _files }') . "\n"
        : '    ' . quoted('*:file:_files') . "\n";
    $zsh .= "}\n";
}
$zsh .= "\n_palpate \"\$@\"\n";
write_file('_palpate', $zsh);
