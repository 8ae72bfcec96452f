#!/usr/bin/perl
# SPDX-License-Identifier: BSD-3-Clause
# check_wording.pl [--all] [--only KIND,…] [ROOT]   counts words that make sentences vague, for each part of the tree, and fails where a part
# has more of them per 1,000 words than plain technical English needs. It prints the parts that fail with their worst files,
# with --all every part; kinds are comments, documents and texts. The bounds leave room for the words where they are right; rewrite the sentence, not the word.
use strict;
use warnings;

my $all = @ARGV && $ARGV[0] eq '--all' && shift @ARGV;
my %only = map { $_ => 1 } @ARGV && $ARGV[0] eq '--only' ? split(/,/, (splice @ARGV, 0, 2)[1]) : qw(comments documents texts);
my $root = shift @ARGV // '.';

# Pattern, most per 1,000 words of comments, and of documents and window texts.
my @markers = (
    ['say, tell', qr/\b(?:say|says|said|saying|tell|tells|told|telling)\b/i, 0.5, 1.0],
    ['what, who', qr/\b(?:what|whatever|who|whom|whose)\b/i, 2.0, 3.0],
    ['it, its', qr/\b(?:it|its|itself)\b/i, 12.0, 14.0],
    ['none, those, of it', qr/\b(?:none|those|that of|of it|of them|of what|anew|besides|lies|for want of|as felt|be it)\b/i, 3.0, 4.0],
);
my $fewest_words = 200; # a rate of fewer words says little

sub comments_of {
    my ($source) = @_;
    my $text = '';
    while ($source =~ m{"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|(//[^\n]*|/\*.*?\*/)}gs) {
        $text .= "$1\n" if defined $1 && $1 !~ /SPDX/;
    }
    return $text;
}

sub window_texts_of {
    my ($source) = @_;
    return join "\n", $source =~ /\btr\(\s*"((?:\\.|[^"\\])*)"/g;
}

sub prose_of {
    my ($page) = @_;
    $page =~ s/```.*?```/ /gs;      # code
    $page =~ s/^    .*$/ /gm;
    $page =~ s/`[^`]*`/ /g;
    $page =~ s/\]\([^)]*\)/]/g;     # targets of links
    return $page;
}

chdir $root or die "$root: $!\n";
open my $list, '-|', 'git', 'ls-files', '-z' or die "git ls-files: $!\n";
my @files = split /\0/, do { local $/; <$list> };
my %parts; # name of a part -> [file, text] ...
for my $file (sort @files) {
    next unless -f $file && $file =~ /\.(?:h|hpp|cpp|cc|cxx|md)$/;
    open my $in, '<:encoding(UTF-8)', $file or die "$file: $!\n";
    my $content = do { local $/; <$in> };
    if ($file =~ /\.md$/) {
        push @{$parts{'documents: ' . ($file =~ /CHANGELOG/ ? 'changelog' : 'pages')}}, [$file, prose_of($content)];
        next;
    }
    my $part = $file =~ m{^modules/([^/]+)/} ? "modules/$1" : $file =~ m{^([^/]+)/} ? $1 : $file;
    push @{$parts{"comments: $part"}}, [$file, comments_of($content)];
    push @{$parts{"texts: $part"}}, [$file, window_texts_of($content)] if $part ne 'tests';
}
die "found no sources below $root\n" unless %parts;

my $bad = 0;
for my $name (sort keys %parts) {
    next unless $only{$name =~ s/:.*//r};
    my $whole = join "\n", map { $_->[1] } @{$parts{$name}};
    my $words = () = $whole =~ /[A-Za-z]+/g;
    next if $words < $fewest_words;
    for my $marker (@markers) {
        my ($label, $pattern, $in_comments, $in_texts) = @$marker;
        my $most = $name =~ /^comments/ ? $in_comments : $in_texts;
        my $count = () = $whole =~ /$pattern/g;
        my $rate = 1000 * $count / $words;
        my $is_bad = $rate > $most;
        printf "%-28s %-20s %5.1f per 1,000 words, at most %.1f%s\n", $name, $label, $rate, $most, $is_bad ? '  <--' : '' if $all || $is_bad;
        next unless $is_bad;
        $bad = 1;
        my @worst = sort { $b->[0] <=> $a->[0] || $a->[1] cmp $b->[1] }
            map { my $n = () = $_->[1] =~ /$pattern/g; [$n, $_->[0]] } @{$parts{$name}};
        printf "    %4d  %s\n", @$_ for grep { $_->[0] > 0 } @worst[0 .. ($#worst < 4 ? $#worst : 4)];
    }
}
print "wording: within its bounds\n" unless $bad;
exit $bad;
