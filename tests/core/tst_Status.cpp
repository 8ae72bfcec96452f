// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Status.h>

#include <memory>

using palpate::core::Result;
using palpate::core::StatusCode;

class Status : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void isOkByDefault()
    {
        const palpate::core::Status status;
        QVERIFY(status.isOk());
        QVERIFY(status.code() == StatusCode::Ok);
        QVERIFY(status.message().empty());
    }

    void carriesCodeAndMessage()
    {
        const palpate::core::Status status(StatusCode::BadFormat, PALPATE_TEXT("liver.stl: cut in facet 12"));
        QVERIFY(!status.isOk());
        QVERIFY(status.code() == StatusCode::BadFormat);
        QCOMPARE(status.message(), std::string("liver.stl: cut in facet 12"));
    }

    void resultHoldsAValue()
    {
        Result<int> result(42);
        QVERIFY(result.isOk());
        QVERIFY(result.status().isOk());
        QCOMPARE(result.value(), 42);
        result.value() = 43;
        QCOMPARE(result.value(), 43);
    }

    void resultHoldsWhyThereIsNone()
    {
        const Result<int> result(palpate::core::Status(StatusCode::NotFound, PALPATE_TEXT("no such file")));
        QVERIFY(!result.isOk());
        QVERIFY(result.status().code() == StatusCode::NotFound);
        QCOMPARE(result.status().message(), std::string("no such file"));
    }

    void resultMovesWhatCannotBeCopied()
    {
        Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
        const std::unique_ptr<int> value = std::move(result).value();
        QCOMPARE(*value, 7);
    }

    void takesAPointerToADerivedClass()
    {
        struct Base
        {
            virtual ~Base() = default;
        };
        struct Derived : Base
        {
        };
        const auto make = []() -> Result<std::unique_ptr<Base>> { return std::make_unique<Derived>(); };
        const Result<std::unique_ptr<Base>> made = make();
        QVERIFY(made.isOk());
        QVERIFY(dynamic_cast<Derived*>(made.value().get()) != nullptr);
        static_assert(!std::is_convertible_v<std::unique_ptr<Base>, Result<std::unique_ptr<Derived>>>);
    }
};

PALPATE_TEST(Status)
#include "tst_Status.moc"
