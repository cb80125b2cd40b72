// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/text_search.h"

#include <QElapsedTimer>
#include <QTest>

using namespace isoscope;

namespace {

QByteArrayList found(const QByteArray& text, const SearchRequest& request) {
    QByteArrayList result;
    for (const SearchMatch& match : searchText(text.toStdString(), request).matches)
        result << text.mid(match.begin, match.end - match.begin);
    return result;
}

SearchRequest plain(const QString& pattern) {
    SearchRequest request;
    request.pattern = pattern;
    return request;
}

}  // namespace

class TextSearchTest : public QObject {
    Q_OBJECT

  private slots:
    void findsPlainText() {
        QCOMPARE(found("a.b A.B axb", plain("a.b")), (QByteArrayList{"a.b", "A.B"}));
        SearchRequest exact = plain("a.b");
        exact.caseSensitive = true;
        QCOMPARE(found("a.b A.B axb", exact), (QByteArrayList{"a.b"}));
        QVERIFY(found("abc", plain("")).isEmpty());
    }

    void wholeWordsHaveNoLettersBeside() {
        SearchRequest request = plain("box");
        request.wholeWord = true;
        QCOMPARE(searchText("box boxed a_box box2 {box}", request).matches.size(), 2u);
        request.pattern = "#if";
        QCOMPARE(searchText("#if #ifdef\n#if(1)", request).matches.size(), 2u);
    }

    void positionsAreBytes() {
        const QByteArray text = "\xf0\x9f\x98\x80 \xe6\xbc\xa2\xc3\xa4 needle \xf0\x9f\x98\x80needle";
        const SearchResult result = searchText(text.toStdString(), plain("needle"));
        QCOMPARE(result.matches.size(), 2u);
        QCOMPARE(result.matches[0].begin, static_cast<int>(text.indexOf("needle")));
        QCOMPARE(result.matches[1].begin, static_cast<int>(text.lastIndexOf("needle")));
        QCOMPARE(found(text, plain(QString::fromUtf8("\xe6\xbc\xa2\xc3\xa4"))),
                 (QByteArrayList{"\xe6\xbc\xa2\xc3\xa4"}));
    }

    void regularExpressionsFillInGroups() {
        SearchRequest request = plain("(\\w+)=(\\d+)");
        request.regular = true;
        request.replacement = "\\2:\\1\\\\";
        const SearchResult result = searchText("a=1 bc=23", request);
        QCOMPARE(result.matches.size(), 2u);
        QCOMPARE(result.matches[0].replacement, QString("1:a\\"));
        QCOMPARE(result.matches[1].replacement, QString("23:bc\\"));
    }

    void plainReplacementsAreLeftAlone() {
        SearchRequest request = plain("a");
        request.replacement = "\\1";
        QCOMPARE(searchText("a", request).matches[0].replacement, QString("\\1"));
    }

    void linesHaveEnds() {
        SearchRequest request = plain("^b$");
        request.regular = true;
        QCOMPARE(searchText("a\nb\nc", request).matches.size(), 1u);
    }

    void emptyMatchesAreNone() {
        SearchRequest request = plain("x*");
        request.regular = true;
        QCOMPARE(found("axxb", request), (QByteArrayList{"xx"}));
    }

    void saysWhatIsWrong() {
        SearchRequest request = plain("(");
        request.regular = true;
        QVERIFY(!searchText("(", request).error.isEmpty());
        QCOMPARE(found("(", plain("(")), (QByteArrayList{"("}));
    }

    void runawayExpressionsEnd() {
        SearchRequest request = plain("(a+)+$");
        request.regular = true;
        const SearchResult result = searchText(std::string(40, 'a') + "b", request);
        QVERIFY(result.matches.empty());
    }

    void stopsCounting() {
        const SearchResult result = searchText(std::string(searchLimit + 10, 'a'), plain("a"));
        QCOMPARE(result.matches.size(), searchLimit);
        QVERIFY(result.cutOff);
    }
};

QTEST_APPLESS_MAIN(TextSearchTest)
#include "text_search_test.moc"
