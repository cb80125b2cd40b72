// SPDX-License-Identifier: GPL-3.0-or-later
// rand.inc, arrays.inc and strings.inc, which come with the program, against what POV-Ray 3.7.0.10 answers.
#include <cmath>
#include <QStringList>
#include <QTest>

#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

/// The string that `text` declares as Result, without an installed POV-Ray.
QString resultOf(const std::string& text) {
    const ParseResult parsed = parseScene(
        "#version 3.7;\n#include \"rand.inc\"\n#include \"arrays.inc\"\n"
        "#include \"strings.inc\"\n#include \"math.inc\"\n" +
        text);
    if (!parsed.ok()) qWarning("%s", problems(parsed).c_str());
    const Value* value = parsed.symbols->find("Result");
    const auto* string = value ? std::get_if<std::string>(&value->data) : nullptr;
    return string ? QString::fromStdString(*string) : QString("no result");
}

}  // namespace

class RandomIncludesTest : public QObject {
    Q_OBJECT

  private slots:
    /// Three or four calls one after another, and the number that the stream gives next.
    void distributions_data() {
        QTest::addColumn<QString>("call");
        QTest::addColumn<QString>("answers");
        const auto row = [](const char* call, const char* answers) {
            QTest::newRow(call) << QString(call) << QString(answers);
        };
        row("SRand(R)", "0.44716582 -0.34004148 0.51152334 -0.24035543 0.25355930");
        row("RRand(1,5,R)", "3.89433164 2.31991704 4.02304668 2.51928914 0.25355930");
        row("Prob(0.5,R)", "0.00000000 1.00000000 0.00000000 1.00000000 0.25355930");
        row("Rand_Cauchy(1,2,R)", "2.69282083 -0.18297260 3.07374621 0.20685204 0.25355930");
        row("Rand_Student(3,R)", "-0.10671868 -0.66861201 -1.68858492 0.84754994 0.50607471");
        row("Rand_Normal(1,2,R)", "0.19380268 0.45440947 1.55859343 4.73853893 0.84107512");
        row("Rand_Gauss(1,2,R)", "0.70427631 -0.76525363 1.07075846 -0.95371105 0.25355930");
        row("Rand_Gamma(2,3,R)", "10.45777865 11.51814584 10.45579689 4.90422897 0.84107512");
        row("Rand_Gamma(0.5,3,R)", "2.20169441 2.40187367 1.94602723 2.70030147 0.50607471");
        row("Rand_Gamma(1,3,R)", "0.97062043 3.32617643 0.84008761 2.90415542 0.25355930");
        row("Rand_Beta(2,3,R)", "0.41216011 0.57594240 0.35588586 0.27407660 0.77979835");
        row("Rand_Chi_Square(3,R)", "5.22888933 5.75907292 5.22789845 2.45211448 0.84107512");
        row("Rand_F_Dist(3,4,R)", "1.61411452 3.79021524 1.22883228 0.84981094 0.77979835");
        row("Rand_F_Dist(5,2,R)", "0.14527031 0.34111937 0.11059491 0.07648298 0.77979835");
        row("Rand_Triangle(1,5,2,R)", "3.17873531 2.16446674 3.28802455 2.27197277 0.25355930");
        row("Rand_Erlang(2,3,R)", "3.42458964 4.72335792 3.37639686 0.55397945 0.68027457");
        row("Rand_Exp(2,R)", "0.16177007 0.55436274 0.14001460 0.48402590 0.25355930");
        row("Rand_Lognormal(1,2,R)", "2.02238257 0.46521592 2.91759155 0.38530847 0.25355930");
        row("Rand_Pareto(2,R)", "1.17558991 1.74083127 1.15029059 1.62259367 0.25355930");
        row("Rand_Weibull(2,3,R)", "1.37300690 2.07000473 1.30847201 1.97847027 0.25355930");
        row("Rand_Bernoulli(0.3,R)", "0.00000000 0.00000000 0.00000000 0.00000000 0.25355930");
        row("Rand_Binomial(5,0.3,R)", "1.00000000 0.00000000 0.00000000 1.00000000 0.50607471");
        row("Rand_Geo(0.3,R)", "0.00000000 3.00000000 0.00000000 2.00000000 0.25355930");
        row("Rand_Poisson(4,R)", "5.00000000 15.00000000 7.00000000 6.00000000 0.25646759");
        row("Rand_Spline(Falling,R)", "0.80133831 0.07311094 0.13439513 0.00536723 0.77292123");
        row("VRand_In_Sphere(R).x", "-0.37154736 -0.00467004 -0.65290189 0.23617410 0.68027457");
        row("VRand_In_Sphere(R).y", "0.67605081 0.20878747 -0.59629073 -0.36665256 0.68027457");
        row("VRand_On_Sphere(R).z", "-0.34004148 -0.24035543 0.95751849 0.23558463 0.41355506");
        row("VRand_In_Box(<1,2,3>,<4,6,8>,R).y", "3.31991704 3.01423719 4.47116927 5.36430046 0.68027457");
    }
    void distributions() {
        QFETCH(QString, call);
        QFETCH(QString, answers);
        const QString found = resultOf(
            "#declare Falling = spline { linear_spline 0, <0.2, 0.9, 0.1> 1, <0.9, 0.1, 0.1> }\n"
            "#declare R = seed(42);\n#declare Result = \"\";\n#declare I = 0;\n#while (I < 4)\n"
            "#declare Result = concat(Result, str(" +
            call.toStdString() +
            ", 0, 8), \" \");\n#declare I = I + 1;\n#end\n"
            "#declare Result = concat(Result, str(rand(R), 0, 8));");
        QCOMPARE(found, answers);
    }

    void pointsInAnObject() {
        QCOMPARE(
            resultOf("#declare Cut = intersection { sphere { 0, 1 } plane { y, 0.25 } }\n"
                     "#declare R = seed(42);\n#declare P = VRand_In_Obj(Cut, R);\n"
                     "#declare Q = VRand_In_Obj(Cut, R);\n"
                     "#declare Result = concat(vstr(3, P, \",\", 0, 8), \" \", vstr(3, Q, \",\", 0, 8));"),
            QString("0.44716582,-0.58752593,0.51152334 0.44703450,-0.22775960,-0.17288987"));
    }

    void arrays() {
        const std::string print =
            "#declare Result = \"\";\n#declare I = 0;\n#while (I < dimension_size(A, 1))\n"
            "#declare Result = concat(Result, str(A[I], 0, 0), \" \");\n"
            "#declare I = I + 1;\n#end\n";
        const std::string a = "#declare A = array[7] {5, 3, 9, 1, 7, 2, 8}\n";
        QCOMPARE(resultOf(a + "Reverse_Array(A)\n" + print), QString("8 2 7 1 9 3 5 "));
        QCOMPARE(resultOf(a + "Sort_Array(A)\n" + print), QString("1 2 3 5 7 8 9 "));
        QCOMPARE(resultOf(a + "Sort_Partial_Array(A, 1, 4)\n" + print), QString("5 1 3 7 9 2 8 "));
        QCOMPARE(resultOf(a + "Resize_Array(A, 3)\n" + print), QString("5 3 9 "));
        QCOMPARE(resultOf(a + "Resize_Array(A, 9)\n#declare Result = str(dimension_size(A, 1), 0, 0);"),
                 QString("9"));
        QCOMPARE(
            resultOf(a + "#declare R = seed(42);\n#declare Result = concat(str(Rand_Array_Item(A, R), 0, 0), "
                         "str(Rand_Array_Item(A, R), 0, 0), str(Rand_Array_Item(A, R), 0, 0));"),
            QString("292"));
        QCOMPARE(resultOf("#macro Sort_Compare(Array, I, J) (Array[I] > Array[J]) #end\n" + a +
                          "Sort_Array(A)\n" + print),
                 QString("9 8 7 5 3 2 1 "));
    }

    void statistics() {
        QCOMPARE(
            resultOf("#declare A = array[7] {5, 3, 9, 1, 7, 2, 8}\nGetStats(A)\n#declare Result = \"\";\n"
                     "#declare I = 0;\n#while (I < 5)\n#declare Result = concat(Result, "
                     "str(StatisticsArray[I], 0, 6), \" \");\n#declare I = I + 1;\n#end"),
            QString("7.000000 5.000000 1.000000 9.000000 2.878492 "));
        QCOMPARE(
            resultOf("#declare A = array[7] {5, 3, 9, 1, 7, 2, 8}\nHistogram(A, 4)\n#declare Result = \"\";\n"
                     "#declare I = 0;\n#while (I < 4)\n#declare Result = concat(Result, "
                     "str(HistogramArray[I][0], 0, 0), \":\", str(HistogramArray[I][1], 0, 0), \" \");\n"
                     "#declare I = I + 1;\n#end"),
            QString("2:2 4:1 6:1 8:3 "));
    }

    void strings_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* expression, const char* text) {
            QTest::newRow(expression) << QString(expression) << QString(text);
        };
        row("CRGBFTStr(rgbft <0.1,0.2,0.3,0.4,0.5>,8,2)",
            "color rgbft <     0.10,     0.20,     0.30,     0.40,     0.50>");
        row("CRGBFTStr(rgbft <0.1,0.2,0.3,0.4,0.5>,0,3)", "color rgbft < 0.100, 0.200, 0.300, 0.400, 0.500>");
        row("CRGBStr(rgb <0.1,0.2,0.3>,8,2)", "color rgb <       0.10,     0.20,     0.30>");
        row("Str(1/3)", "0.333333");
        row("VStr2D(<1,2.5>)", "<1.000000,2.500000>");
        row("VStr(<1/3,2,3>)", "<0.333333,2.000000,3.000000>");
        row("Vstr2D(<1,2.5>,0,2)", "<1.00,2.50>");
        row("Vstr(<1,2,3>,6,2)", "<  1.00,  2.00,  3.00>");
        row("Triangle_Str(x,y,z)",
            "triangle "
            "{<1.000000,0.000000,0.000000>,<0.000000,1.000000,0.000000>,<0.000000,0.000000,1.000000>}");
        row("str(Parse_String(\"2*(3+4)\"),0,1)", "14.0");
    }
    void strings() {
        QFETCH(QString, expression);
        QFETCH(QString, text);
        QCOMPARE(resultOf("#declare Result = " + expression.toStdString() + ";"), text);
    }
};

QTEST_APPLESS_MAIN(RandomIncludesTest)
#include "random_includes_test.moc"
