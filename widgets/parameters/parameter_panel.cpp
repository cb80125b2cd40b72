// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_panel.h"

#include <algorithm>
#include <cctype>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "core/language/sliders/value_preset.h"
#include "widgets/icons.h"
#include "widgets/numbers/number_text.h"
#include "widgets/parameters/parameter_group.h"
#include "widgets/parameters/parameter_groups.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/slider_player.h"

namespace isoscope {
namespace {

QString groupId(const ParameterPlace& place) { return place.group + '\n' + QString::number(place.call); }

/// Where the statement or call begins that the parameter, its first, belongs to: its word stands in front of
/// its numbers.
int lineOf(const SourceText& source, const SceneParameter& first) {
    const std::string_view text = source.text();
    const std::string_view word = first.group;
    const auto isWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    std::size_t at = first.range.begin;
    while (!word.empty() && at > 0 && (at = text.rfind(word, at - 1)) != std::string_view::npos) {
        const std::size_t end = at + word.size();
        const bool whole = (at == 0 || !isWord(text[at - 1])) && (end >= text.size() || !isWord(text[end]));
        if (whole) return source.position(static_cast<std::uint32_t>(at)).line;
    }
    return source.position(first.range.begin).line;
}

/// What the text says about the slider of a number.
std::optional<SliderNote> noteOf(const SceneParameter& parameter, const SourceLibrary* sources) {
    if (!sources || sources->size() == 0 || parameter.implied || parameter.expression) return std::nullopt;
    return parameter.range.file == 0 ? sliderNoteBehind((*sources)[0].text(), parameter.range.end)
                                     : std::nullopt;
}

}  // namespace

ParameterPanel::ParameterPanel(QWidget* parent) : QWidget(parent), player_(new SliderPlayer(this)) {
    filter_ = new QLineEdit(this);
    filter_->setPlaceholderText(tr("Filter parameters"));
    filter_->setClearButtonEnabled(true);
    filter_->setToolTip(tr("Shows only parameters whose name or function contains these words"));
    filter_->setAccessibleName(tr("Filter parameters"));
    filter_->addAction(themeIcon("view-filter"), QLineEdit::LeadingPosition);
    connect(filter_, &QLineEdit::textChanged, this, &ParameterPanel::applyFilter);

    auto* body = new QWidget(this);
    list_ = new QVBoxLayout(body);
    list_->setContentsMargins(4, 4, 8, 4);
    list_->setSpacing(4);
    empty_ = new QLabel(body);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setMargin(16);
    list_->addWidget(empty_);
    list_->addStretch(1);

    scroll_ = new QScrollArea(this);
    scroll_->setWidget(body);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setAccessibleName(tr("Parameters"));
    scroll_->setToolTip(tr("Numbers of the scene. A double click on a name brings its first value back"));
    scroll_->setFocusPolicy(Qt::NoFocus);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    tools_ = new QHBoxLayout;
    tools_->setSpacing(2);
    tools_->addWidget(filter_, 1);
    buildTools();
    layout->addLayout(tools_);
    bars_ = new QVBoxLayout;
    layout->addLayout(bars_);
    layout->addWidget(scroll_, 1);
    setAccessibleName(tr("Parameters"));
    applyFilter();
}

ParameterPanel::~ParameterPanel() = default;

void ParameterPanel::setParameters(const std::vector<SceneParameter>& parameters,
                                   const SourceLibrary* sources) {
    const std::vector<ParameterPlace> places = parameterPlaces(parameters);
    std::vector<Row> old = std::move(rows_);
    rows_.clear();
    bool sameRows = old.size() == std::min<std::size_t>(parameters.size(), rowLimit);
    for (std::size_t i = 0; i < parameters.size() && i < rowLimit; ++i) {
        const auto kept = std::find_if(old.begin(), old.end(), [&](const Row& row) {
            return row.slider && row.key == places[i].key && row.slider->canShow(parameters[i]);
        });
        Row row{places[i].key, places[i].presetName, nullptr};
        if (kept == old.end()) {
            row.slider = makeSlider(parameters[i], row.key);
            sameRows = false;
        } else {
            sameRows = sameRows && kept - old.begin() == static_cast<std::ptrdiff_t>(i);
            row.slider = std::exchange(kept->slider, nullptr);
        }
        row.slider->setParameter(parameters[i], noteOf(parameters[i], sources));
        rows_.push_back(std::move(row));
    }
    for (std::size_t i = 0; i < old.size(); ++i) {
        if (!old[i].slider) continue;
        // Whoever opened an undo group for the drag must hear that it is over.
        const bool dragged = old[i].slider->isDragging();
        if (old[i].slider->isPlaying()) player_->abandon();
        old[i].slider->disconnect(this);
        old[i].slider->hide();
        old[i].slider->deleteLater();
        if (dragged) emit dragFinished(static_cast<int>(i));
    }
    hidden_ = static_cast<int>(parameters.size() - rows_.size());
    arrange(places, parameters, sources, sameRows);
}

void ParameterPanel::clear() {
    player_->abandon();
    setParameters({});
    initialValues_.clear();
    filter_->clear();
}

void ParameterPanel::setValue(int index, double value) {
    if (ParameterSlider* row = slider(index)) row->setValue(value);
}

ParameterSlider* ParameterPanel::sliderAt(const SourceRange& number) const {
    for (const Row& row : rows_) {
        if (!row.slider) continue;
        const SourceRange& range = row.slider->parameter().range;
        if (range.file == number.file && range.begin == number.begin && range.end == number.end)
            return row.slider;
    }
    return nullptr;
}

ParameterSlider* ParameterPanel::settingOf(const SourceRange& statement, ParameterRole role) const {
    for (const Row& row : rows_) {
        if (!row.slider || row.slider->parameter().role != role) continue;
        const SourceRange& range = row.slider->parameter().range;
        if (range.file == statement.file && statement.begin <= range.begin && range.end <= statement.end)
            return row.slider;
    }
    return nullptr;
}

ParameterSlider* ParameterPanel::slider(int index) const {
    return index >= 0 && index < count() ? rows_[static_cast<std::size_t>(index)].slider : nullptr;
}

void ParameterPanel::settle() {
    player_->stop();
    for (const Row& row : rows_) row.slider->settle();
}

QString ParameterPanel::textFor(int index, double value) const {
    const ParameterSlider* row = slider(index);
    return numberTextWith(value, row ? row->decimals() : -1);
}

void ParameterPanel::addTool(QWidget* tool) { tools_->addWidget(tool); }

void ParameterPanel::addBar(QWidget* bar) { bars_->addWidget(bar); }

void ParameterPanel::buildTools() {
    const auto add = [&](const char* icon, const QString& name, const QString& help, auto act) {
        auto* button = new QToolButton(this);
        button->setAutoRaise(true);
        button->setIcon(themeIcon(icon));
        button->setFocusPolicy(Qt::StrongFocus);
        button->setText(name);
        button->setToolTip(help);
        button->setAccessibleName(name);
        connect(button, &QToolButton::clicked, this, act);
        addTool(button);
    };
    add("randomize", tr("Randomise"),
        tr("Random values for the numbers listed here; locked ones, containers, accuracy and max_gradient "
           "stay"),
        &ParameterPanel::randomise);
    add("edit-reset", tr("Reset all"),
        tr("Brings the first values of the numbers listed here back; locked ones stay"),
        &ParameterPanel::resetAll);
}

void ParameterPanel::choose(const std::function<std::optional<double>(const ParameterSlider&)>& value) {
    settle();
    std::vector<std::pair<int, double>> values;
    for (int i = 0; i < count(); ++i) {
        const ParameterSlider& row = *rows_[static_cast<std::size_t>(i)].slider;
        const SceneParameter& parameter = row.parameter();
        if (row.isHidden() || row.isLocked() || parameter.expression || parameter.implied) continue;
        const std::optional<double> wanted = value(row);
        if (wanted && *wanted != row.value()) values.emplace_back(i, *wanted);
    }
    if (!values.empty()) emit valuesChosen(values);
}

void ParameterPanel::randomise() {
    choose([](const ParameterSlider& row) -> std::optional<double> {
        switch (row.parameter().role) {
            case ParameterRole::accuracy:
            case ParameterRole::maxGradient:
            case ParameterRole::container: return std::nullopt;
            default: return row.randomValue();
        }
    });
}

void ParameterPanel::resetAll() {
    choose([](const ParameterSlider& row) { return row.initialValue(); });
}

std::vector<std::pair<std::string, double>> ParameterPanel::presetValues() const {
    std::vector<std::pair<std::string, double>> values;
    for (const Row& row : rows_) {
        const SceneParameter& parameter = row.slider->parameter();
        if (parameter.expression || parameter.implied) continue;
        values.emplace_back(row.presetName.toStdString(), row.slider->value());
    }
    return values;
}

ParameterPanel::Applied ParameterPanel::applyPreset(const ValuePreset& preset) {
    settle();
    Applied applied;
    std::vector<std::pair<int, double>> values;
    for (const auto& [name, value] : preset.values) {
        const QString wanted = QString::fromStdString(name);
        const auto row = std::find_if(rows_.begin(), rows_.end(),
                                      [&](const Row& one) { return one.presetName == wanted; });
        if (row == rows_.end() || row->slider->parameter().expression || row->slider->parameter().implied)
            ++applied.missing;
        else if (row->slider->isLocked())
            ++applied.locked;
        else if (row->slider->value() != value)
            values.emplace_back(static_cast<int>(row - rows_.begin()), value);
    }
    if (!values.empty()) emit valuesChosen(values);
    return applied;
}

ParameterSlider* ParameterPanel::makeSlider(const SceneParameter& parameter, const QString& key) {
    auto* slider = new ParameterSlider(parameter, scroll_->widget());
    // An error in the text may have taken the row away for a moment.
    if (const auto known = initialValues_.constFind(key); known != initialValues_.constEnd())
        slider->setInitialValue(*known);
    else
        initialValues_.insert(key, parameter.value);
    slider->offerPlay();
    connect(slider, &ParameterSlider::playRequested, this,
            [this, slider](bool on) { on ? player_->start(indexOf(slider)) : player_->stop(); });
    connect(slider, &ParameterSlider::keyRequested, this, [this, slider] {
        if (const int index = indexOf(slider); index >= 0)
            emit keyRequested(rows_[static_cast<std::size_t>(index)].presetName);
    });
    connect(slider, &ParameterSlider::noteChanged, this,
            [this, slider](const auto& note) { emit noteChanged(indexOf(slider), note); });
    connect(slider, &ParameterSlider::valueChanged, this,
            [this, slider](double value) { emit valueChanged(indexOf(slider), value); });
    connect(slider, &ParameterSlider::dragStarted, this,
            [this, slider] { emit dragStarted(indexOf(slider)); });
    connect(slider, &ParameterSlider::dragFinished, this,
            [this, slider] { emit dragFinished(indexOf(slider)); });
    connect(slider, &ParameterSlider::replaceExpressionRequested, this,
            [this, slider] { emit replaceExpressionRequested(indexOf(slider)); });
    return slider;
}

int ParameterPanel::indexOf(const ParameterSlider* slider) const {
    const auto row =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.slider == slider; });
    return row == rows_.end() ? -1 : static_cast<int>(row - rows_.begin());
}

void ParameterPanel::arrange(const std::vector<ParameterPlace>& places,
                             const std::vector<SceneParameter>& parameters, const SourceLibrary* sources,
                             bool sameRows) {
    QStringList order;
    QHash<QString, QList<std::size_t>> members;
    QHash<QString, int> calls;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QString id = groupId(places[i]);
        if (!members.contains(id)) order << id;
        members[id] << i;
        calls[places[i].group] = std::max(calls[places[i].group], places[i].call + 1);
    }
    for (const QString& id : order) {
        ParameterGroup*& group = groups_[id];
        if (!group) group = new ParameterGroup(scroll_->widget());
        const std::size_t first = members[id].front();
        const ParameterPlace& place = places[first];
        QString title = place.group.isEmpty() ? tr("Other") : place.group;
        if (calls[place.group] > 1) title += QString(" (%1)").arg(place.call + 1);
        const SourceRange& range = parameters[first].range;
        if (sources && range.file < sources->size()) {
            const SourceText& text = (*sources)[range.file];
            const int from = lineOf(text, parameters[first]);
            int to = from;
            // Declarations have no statement in common; they stand where they like.
            if (place.group == "#declare")
                for (const std::size_t i : members[id])
                    if (parameters[i].range.file == range.file)
                        to = std::max(to, lineOf(text, parameters[i]));
            title += to > from ? tr(", lines %1 to %2").arg(from).arg(to) : tr(", line %1").arg(from);
        }
        group->setTitle(title);
    }
    if (!sameRows) {
        const QStringList known = groups_.keys();
        for (const QString& id : known)
            if (!members.contains(id)) delete groups_.take(id);
        for (qsizetype i = 0; i < order.size(); ++i) {
            groups_[order[i]]->setRows(rowsOf(members[order[i]], parameters));
            list_->removeWidget(groups_[order[i]]);
            list_->insertWidget(static_cast<int>(i), groups_[order[i]]);
        }
    }
    applyFilter();
}

/// The settings of an isosurface keep their order, wherever the text has them: a row must not jump when a
/// drag writes its setting into the text.
QList<QWidget*> ParameterPanel::rowsOf(QList<std::size_t> members,
                                       const std::vector<SceneParameter>& parameters) const {
    std::stable_sort(members.begin(), members.end(),
                     [&](std::size_t a, std::size_t b) { return parameters[a].role < parameters[b].role; });
    QList<QWidget*> rows;
    for (const std::size_t i : members) rows << rows_[i].slider;
    return rows;
}

void ParameterPanel::applyFilter() {
    const QStringList words = filter_->text().split(' ', Qt::SkipEmptyParts);
    bool anyShown = false;
    for (const Row& row : rows_) {
        const bool shown = std::all_of(words.begin(), words.end(), [&](const QString& word) {
            return row.slider->fullName().contains(word, Qt::CaseInsensitive);
        });
        row.slider->setVisible(shown);
        anyShown = anyShown || shown;
    }
    for (ParameterGroup* group : std::as_const(groups_)) group->setVisible(group->hasShownRows());
    if (rows_.empty())
        empty_->setText(
            tr("Nothing to move yet.\nNumbers of function calls, #declare, threshold, accuracy, "
               "max_gradient and contained_by appear here."));
    else if (!anyShown)
        empty_->setText(tr("No parameter matches the filter."));
    else if (hidden_ > 0)
        empty_->setText(
            tr("%n more number(s) are not shown; drag them in the text with Ctrl.", nullptr, hidden_));
    empty_->setVisible(!anyShown || hidden_ > 0);
    // Never so narrow that a row would be cut off: there is no horizontal scroll bar.
    QWidget* body = scroll_->widget();
    body->layout()->activate();
    scroll_->setMinimumWidth(body->minimumSizeHint().width() +
                             scroll_->verticalScrollBar()->sizeHint().width());
}

}  // namespace isoscope
