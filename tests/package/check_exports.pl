#!/usr/bin/env perl
# SPDX-License-Identifier: BSD-3-Clause
# check_exports.pl PREFIX   names each function that the static libraries in PREFIX define and a public header declares
# without PALPATE_EXPORT: shared libraries would hide it from the programs that call it.
use strict;
use warnings;

my ($prefix) = @ARGV;
my ($checked, $hidden) = (0, 0);
chomp(my @archives = `find '$prefix' -name 'libpalpate_*.a'`);
for my $archive (@archives) {
    my ($module) = $archive =~ /libpalpate_(\w+)\.a$/;
    my %in; # declarations by the name of the function, and by "class" and the name of the class
    for my $header (glob "$prefix/include/palpate/$module/*.h") {
        open my $file, '<', $header or die "$header: $!\n";
        my $text = do { local $/; <$file> };
        $text =~ s{//[^\n]*}{}g;
        push @{$in{"class $2"}}, $1 while $text =~ /\b((?:class|struct)\s+(?:PALPATE_EXPORT\s+)?(\w+)[^;{}()]*)\{/g;
        for my $statement (split /[;{}]/, $text) {
            push @{$in{$1}}, $statement while $statement =~ /\b(\w+)\s*\(/g;
        }
    }
    my %seen;
    for (`nm -C --defined-only '$archive' 2>/dev/null`) {
        # Inline functions are weak; functions of unnamed and internal namespaces have longer names.
        my ($outer, $name) = / T palpate::${module}::(?:(\w+)::)?(~?\w+)\(/ or next;
        my $key = defined $outer ? "class $outer" : $name;
        next if $seen{"$key $name"}++ or !$in{$key};
        $checked++;
        next if grep { /\bPALPATE_EXPORT\b/ } @{$in{$key}};
        next if defined $outer and grep { /\bPALPATE_EXPORT\b/ } @{$in{$name} || []};
        print "palpate/$module: ", defined $outer ? "${outer}::" : '', "$name(): expected PALPATE_EXPORT in its declaration\n";
        $hidden++;
    }
}
die "found $checked functions of public headers in $prefix, expected some hundreds\n" if $checked < 100;
exit($hidden ? 1 : 0);
