#!/usr/bin/perl
# SPDX-License-Identifier: BSD-3-Clause
# check_includes.pl [ROOT]   finds names that a file of modules, plugins or app uses without an include for them.
# Sources are compiled many at a time, where an earlier one may provide what a later one lacks. Compiling each by itself
# takes minutes (.ci/run files); this takes seconds, from the text alone. Known are the names that have one place:
# most of the standard library, classes of Qt and VTK (a header of the same name), types and functions that one of our
# public or internal headers declares. An include counts by way of our own headers, too. A class that is only named,
# not used, may be declared instead. Exit code: 0 nothing found, 1 something found.
use strict;
use warnings;
use File::Find;

my $root = shift @ARGV // '.';
chdir $root or die "$root: $!\n";

my %standard; # name after std:: → headers of which each provides it
sub provide { my ($headers, @names) = @_; $standard{$_} = [split / /, $headers] for @names; }
provide('vector', 'vector');
provide('array', 'array');
provide('optional', qw(optional nullopt make_optional));
provide('string sstream filesystem', qw(string to_string stoi stod));
provide('string_view string filesystem', 'string_view');
provide('filesystem', 'filesystem');
provide('map', qw(map multimap));
provide('set', qw(set multiset));
provide('unordered_map', 'unordered_map');
provide('unordered_set', 'unordered_set');
provide('memory', qw(unique_ptr shared_ptr make_unique make_shared weak_ptr enable_shared_from_this));
provide('functional', qw(function hash reference_wrapper ref cref plus less greater invoke));
provide('atomic', qw(atomic atomic_flag memory_order_acquire memory_order_release memory_order_relaxed atomic_thread_fence));
provide('mutex', qw(mutex lock_guard unique_lock call_once once_flag));
provide('condition_variable', 'condition_variable');
provide('thread', qw(thread jthread this_thread));
provide('chrono', 'chrono');
provide('span', 'span');
provide('limits', 'numeric_limits');
provide('numbers', 'numbers');
provide('numeric', qw(accumulate iota inner_product partial_sum gcd lcm midpoint reduce));
provide('algorithm', qw(sort stable_sort find_if find_if_not any_of all_of none_of count_if transform copy_if copy_n
    nth_element partial_sort lower_bound upper_bound equal_range binary_search minmax_element min_element max_element
    clamp fill fill_n replace replace_if remove_if unique rotate shuffle generate for_each_n adjacent_find mismatch
    partition is_sorted set_difference set_intersection lexicographical_compare sort_heap push_heap pop_heap make_heap));
provide('cmath', qw(sqrt sin cos tan asin acos atan atan2 pow exp log log2 log10 hypot floor ceil round trunc lround llround
    fmod isfinite isnan isinf fma cbrt ldexp frexp nextafter copysign erf sinh cosh tanh nearbyint signbit remainder));
provide('cstring', qw(memcpy memcmp memset memmove strlen strcmp strerror strchr strstr strncmp));
provide('cstdio', qw(printf fprintf snprintf fopen fclose fputs fflush FILE));
provide('cstdlib', qw(getenv exit abort strtod strtol strtoul));
provide('fstream', qw(ifstream ofstream fstream));
provide('sstream', qw(istringstream ostringstream stringstream));
provide('bit', qw(bit_cast endian popcount countr_zero countl_zero bit_width has_single_bit));
provide('charconv', qw(from_chars to_chars));
provide('tuple', qw(tuple tie make_tuple));
provide('variant', qw(variant visit get_if holds_alternative));
provide('deque', 'deque');
provide('random', qw(mt19937 mt19937_64 uniform_real_distribution uniform_int_distribution normal_distribution));
provide('iterator', qw(back_inserter inserter istreambuf_iterator make_move_iterator));
provide('latch', 'latch');
provide('system_error fstream filesystem thread mutex', qw(error_code errc error_condition system_error generic_category));
provide('type_traits', qw(is_same_v enable_if_t is_trivially_copyable_v is_enum_v underlying_type_t invoke_result_t
    remove_cvref_t is_convertible_v is_nothrow_move_constructible_v is_floating_point_v is_integral_v));
provide('cfenv', qw(fesetround fegetround feclearexcept fetestexcept));

# Names that every header of Qt or VTK provides, and names that another header provides: its base class, or what its
# functions take by value.
my %of_any = map { $_ => 1 } qw(QString QStringView QStringList QStringLiteral QLatin1String QLatin1Char QByteArray
    QByteArrayView QChar QObject QMetaObject QVariant QList QPoint QPointF QSize QSizeF QRect QRectF
    vtkIdType vtkTypeMacro vtkStandardNewMacro vtkTemplateMacro);
my @widgets = qw(QWidget QDialog QDockWidget QFrame QLabel QMainWindow QAbstractButton QPushButton QToolButton QComboBox
    QTreeView QTableView QTableWidget QListView QLineEdit QAbstractScrollArea QScrollArea QTabBar QMenu QApplication);
my @models = qw(QAbstractTableModel QAbstractListModel QStandardItemModel QSortFilterProxyModel);
my @views = qw(QTreeView QTableView QTableWidget QListView);
my %others = (
    QWidget => \@widgets, QPalette => \@widgets, QSizePolicy => \@widgets, QMargins => ['QLayout', @widgets],
    QFont => ['QPainter', @widgets], QFontMetrics => ['QPainter', @widgets], QFontMetricsF => ['QPainter'],
    QPen => ['QPainter'], QBrush => ['QPainter', 'QPalette'], QPolygonF => ['QPainter'], QPixmap => ['QPainter', 'QIcon'],
    QEvent => [qw(QKeyEvent QMouseEvent QWheelEvent), @widgets], QFrame => ['QLabel', @views],
    QIODevice => [qw(QFile QSaveFile QBuffer QLocalSocket QProcess)], QFileDevice => ['QFile'],
    QAbstractItemModel => \@models, QModelIndex => ['QAbstractItemModel', @models],
    QAbstractItemView => \@views, QItemSelectionModel => \@views, QTableWidgetItem => ['QTableWidget'],
    QJsonValue => [qw(QJsonObject QJsonArray)], QJsonParseError => ['QJsonDocument'],
    QKeySequence => [qw(QShortcut QAction)], QCoreApplication => [qw(QApplication QGuiApplication)],
    (map { $_ => ['QAccessible'] } qw(QAccessibleEvent QAccessibleValueInterface QAccessibleValueChangeEvent)),
    QGuiApplication => ['QApplication'], QRegularExpressionMatch => ['QRegularExpression'],
    QTextLine => ['QTextLayout'],
);

my %text;  # path → source without comments and string literals
my %lines; # path → its includes
sub read_file {
    my ($path) = @_;
    open my $in, '<', $path or die "$path: $!\n";
    local $/;
    my $source = <$in>;
    close $in;
    $lines{$path} = [$source =~ /^\s*#\s*include\s+[<"]([^>"]+)[>"]/mg];
    $source =~ s{R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![\w])'(?:\\.|[^'\\\n])+'|//[^\n]*|/\*.*?\*/}{defined $1 ? '""' : ' '}gse;
    $source =~ s/^\s*#.*(?:\\\n.*)*$//mg;
    $text{$path} = $source;
}

my @files;
find({no_chdir => 1, wanted => sub { push @files, $_ if /\.(?:h|cpp)$/ && !m{/build/} }}, grep { -d } qw(modules plugins app));
@files = sort @files;
read_file($_) for @files;

# An include of ours → its file: below the module's include or src folder, or beside the file.
sub resolve {
    my ($from, $name) = @_;
    my ($folder) = $from =~ m{^(.*)/};
    my ($module) = $from =~ m{^(modules/[^/]+|plugins/[^/]+|plugins|app)/};
    for my $candidate ("$folder/$name", "$module/src/$name", "$module/include/$name", "$module/$name", "plugins/$name",
        $name =~ m{^palpate/([^/]+)/} ? "modules/$1/include/$name" : ()) {
        my $path = $candidate;
        1 while $path =~ s{[^/]+/\.\./}{};
        return $path if exists $text{$path};
    }
    return undef;
}

my %closure; # path → {include, as written, or our file → 1}
sub closure_of {
    my ($path) = @_;
    return $closure{$path} if $closure{$path};
    my $all = $closure{$path} = {$path => 1};
    for my $name (@{$lines{$path}}) {
        my $own = resolve($path, $name);
        if (defined $own) {
            my $of = closure_of($own);
            $all->{$_} = 1 for keys %$of;
        } else {
            my ($last) = $name =~ m{([^/]+)$};
            $all->{$last} = 1;
        }
    }
    return $all;
}

my %place; # name that our headers define → files
for my $path (grep { /\.h$/ } @files) {
    my $source = $text{$path};
    my %names;
    $names{$1} = 1 while $source =~ /^(?:class|struct|enum class|enum)\s+(?:\[\[\w+\]\]\s+)?(?:PALPATE_\w+\s+)?(\w+)\s*(?:final\s*)?(?::[^:;{][^;{]*)?\s*\{/mg;
    $names{$1} = 1 while $source =~ /^(?:\[\[nodiscard\]\]\s+)?(?:PALPATE_\w+\s+)?(?:inline\s+|constexpr\s+)*[\w:<>,&*\s]*?[\w>&*]\s+[&*]?(\w+)\(/mg;
    $place{$_}{$path} = 1 for keys %names;
}
# Names that also mean something else, as a member, a local one or one of a source, cannot be judged.
my (%member, %defined);
for my $path (@files) {
    my $source = $text{$path};
    $member{$1} = 1 while $source =~ /^[ \t]+(?!return\b|throw\b|else\b|case\b)(?:\[\[nodiscard\]\]\s+)?(?:(?:static|virtual|inline|constexpr|explicit|class|struct|enum|enum class)\s+)*(?:[\w:&*]+(?:<[^;(){}]*>)?[&*]*\s+)*[&*]?(\w+)\s*(?:\([^;{}]*\)[^;{},]*[;{]|\{|;)/mg;
    $member{$1} = 1 while $source =~ /\bauto&?\s+(\w+)\s*[={]/g;
    next if $path =~ /\.h$/;
    $defined{$1}{$path} = 1 while $source =~ /^(?:class|struct|enum class|enum)\s+(\w+)/mg;
    $defined{$1}{$path} = 1 while $source =~ /^[\w:<>,&*\s]*?[\w>&*]\s+[&*]?(\w+)\(/mg;
}

my $found = 0;
for my $path (@files) {
    my ($source, $has) = ($text{$path}, closure_of($path));
    my %lacking;
    while ($source =~ /\bstd::(\w+)/g) {
        my $headers = $standard{$1} or next;
        $lacking{"std::$1"} = "<$headers->[0]>" unless grep { $has->{$_} } @$headers;
    }
    while ($source =~ /\b(Q[A-Z]\w+|vtk[A-Z]\w+)(?:::|\s*[({]|\s+\w+\s*[;({=])/g) {
        my $name = $1;
        next if $name =~ /^Q_|^QT_/ || $of_any{$name};
        my $header = $name =~ /^vtk/ ? "$name.h" : $name;
        $lacking{$name} = "<$header>" unless grep { $has->{$_} } $header, @{$others{$name} // []};
    }
    while ($source =~ /(?<![\w.>])(?:(?:\w+)::)?(\w+)(?=\s*[({]|::|\s+\w+\s*[;({=])/g) {
        my $at = $place{$1} or next;
        next if keys %$at != 1 || $1 eq 'volatile'; # a keyword
        my ($header) = keys %$at;
        next if $has->{$header} || $member{$1} || grep { !closure_of($_)->{$header} } keys %{$defined{$1} // {}};
        $lacking{$1} = $header;
    }
    for my $name (sort keys %lacking) {
        print "$path: uses $name without $lacking{$name}\n";
        ++$found;
    }
}
print "$found names without an include\n" if $found;
exit($found ? 1 : 0);

