#include "gui/paint/FacePainter.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <osg/Geometry>

#include "gui/paint/BoxMouse.h"
#include "gui/paint/NewEntryDialog.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/model/Painting.h"

namespace smat::gui {
namespace {

/// From model axes to the window of the view: see FaceBox.
irsg::Matrix4 pictureOf(const ViewProjection& through, const irsg::Pose& pose) {
    const irsg::Rotation toWorld = pose.attitude.rotation();
    const irsg::Vec3 right = through.eye.right, up = through.eye.up, ahead = through.eye.forward();
    const auto row = [&](irsg::Matrix4& m, std::size_t i, const irsg::Vec3& v) {
        const double depth = irsg::dot(v, ahead), f = through.focalLength_px;
        m(i, 0) = f * irsg::dot(v, right) + 0.5 * through.window.width() * depth;
        m(i, 1) = -f * irsg::dot(v, up) + 0.5 * through.window.height() * depth;
        m(i, 2) = m(i, 3) = depth;
    };
    irsg::Matrix4 m;
    row(m, 0, toWorld * irsg::Vec3{1, 0, 0});
    row(m, 1, toWorld * irsg::Vec3{0, 1, 0});
    row(m, 2, toWorld * irsg::Vec3{0, 0, 1});
    row(m, 3, pose.position_m - through.eye.position_m);
    return m;
}

/// How much longer a length is in metres than in the unit of the file.
double unitOf(const irsg::Matrix4& m) {
    const irsg::Vec3 x{m(0, 0), m(0, 1), m(0, 2)}, y{m(1, 0), m(1, 1), m(1, 2)},
        z{m(2, 0), m(2, 1), m(2, 2)};
    return std::cbrt(std::abs(irsg::dot(x, irsg::cross(y, z))));
}

irsg::Choosing choosingBy(Qt::KeyboardModifiers modifiers) {
    return modifiers & Qt::ControlModifier ? irsg::Choosing::takeAway
           : modifiers & Qt::ShiftModifier ? irsg::Choosing::add
                                           : irsg::Choosing::anew;
}

} // namespace

FacePainter::FacePainter(Workbench& workbench, const Dialogs& dialogs, SceneView& view,
                         PaintDock& dock, std::function<void(const EntryKey&)> openEntry,
                         QObject* parent)
    : QObject(parent),
      workbench_(workbench),
      dialogs_(dialogs),
      view_(view),
      dock_(dock),
      openEntry_(std::move(openEntry)),
      box_(new BoxMouse(&view)) {
    view_.setClickHandler([this](const QPointF& point, Qt::KeyboardModifiers modifiers) {
        return click(point, modifiers, dock_.pickBy());
    });
    connect(box_, &BoxMouse::boxed, this, &FacePainter::takeBox);
    connect(box_, &BoxMouse::clicked, this,
            [this](const QPointF& point, Qt::KeyboardModifiers modifiers) {
                click(point, modifiers, PickBy::face);
            });
    connect(&view_.navigation(), &ViewNavigation::dismissed, this, [this] { choose({}); });
    connect(&workbench_.painted(), &PaintedModels::changed, this, &FacePainter::showPaint);
    connect(&workbench_.database(), &DatabaseSession::changed, this, [this] {
        fillBoxes();
        refreshCodes();
    });
    connect(&workbench_.database(), &DatabaseSession::opened, this, &FacePainter::fillBoxes);
    connectDock();
    refreshChosen();
}

void FacePainter::connectDock() {
    connect(&dock_, &QDockWidget::visibilityChanged, this, &FacePainter::setActive);
    connect(&dock_, &PaintDock::pickByChosen, this,
            [this] { box_->setOn(isActive_ && dock_.pickBy() == PickBy::box); });
    connect(&dock_, &PaintDock::modelChosen, this,
            [this](int model) { workbench_.chooseModel(static_cast<std::size_t>(model)); });
    connect(&workbench_, &Workbench::modelChosen, this, [this] {
        number_ = static_cast<int>(workbench_.chosenModel());
        if (isActive_)
            readMesh();
    });
    connect(&workbench_, &Workbench::projectOpened, this, [this] { number_ = 0; });
    connect(&dock_, &PaintDock::paintWanted, this, [this] { paint(false); });
    connect(&dock_, &PaintDock::eraseWanted, this, [this] { paint(true); });
    connect(&dock_, &PaintDock::clearWanted, this, [this] { choose({}); });
    connect(&dock_, &PaintDock::shownChosen, this, [this] {
        if (dock_.shown() != CodesShown::none)
            view_.setDisplay(ViewDisplay::visible);
        refreshCodes();
    });
    connect(&dock_, &PaintDock::indexWanted, this, &FacePainter::chooseIndex);
    connect(&dock_.temperature(), &IndexBox::newEntryWanted, this,
            [this] { addEntry(EntryKind::temperature); });
    connect(&dock_.material(), &IndexBox::newEntryWanted, this,
            [this] { addEntry(EntryKind::material); });
}

void FacePainter::setActive(bool active) {
    isActive_ = active;
    box_->setOn(active && dock_.pickBy() == PickBy::box);
    if (active) {
        view_.setHighlighted({});
        readMesh();
    } else {
        choose({});
        view_.setCodeColors(nullptr);
    }
}

void FacePainter::followScene() {
    // Painted while the models were being read.
    std::set<std::filesystem::path> files;
    for (const DisplayModel& model : view_.scene().models)
        files.insert(model.key.file);
    if (workbench_.painted().isDirty())
        for (const auto& file : files)
            showPaint(file);
    if (isActive_)
        readMesh();
}

bool FacePainter::isReady() const {
    return mesh_ && !reading_.isBusy() &&
           std::ranges::none_of(paints_, [](const auto& one) { return one.second->isBusy(); });
}

const DisplayModel* FacePainter::shown() const {
    const auto& models = view_.scene().models;
    return number_ < static_cast<int>(models.size()) ? &models[static_cast<std::size_t>(number_)]
                                                     : nullptr;
}

std::shared_ptr<const irsg::Model> FacePainter::model() const {
    const DisplayModel* of = shown();
    const auto& loaded = view_.scene().loaded;
    const auto found = of == nullptr ? loaded.end() : loaded.find(of->key);
    return found == loaded.end() ? nullptr : found->second;
}

void FacePainter::readMesh() {
    const auto& models = view_.scene().models;
    if (number_ >= static_cast<int>(models.size()))
        number_ = 0;
    QStringList names;
    for (const DisplayModel& one : models)
        names << one.name;
    dock_.setModels(names, number_);
    if (!model()) {
        mesh_ = nullptr;
        chosen_.clear();
        reading_.cancel();
        refreshChosen();
        refreshCodes();
        fillBoxes();
        return;
    }
    const ModelKey key = shown()->key;
    if (key.file != key_.file) {
        mesh_ = nullptr;
        chosen_.clear();
        colors_[0].clear();
        colors_[1].clear();
    }
    key_ = key;
    using Mesh = std::shared_ptr<const irsg::FaceMesh>;
    reading_.run<Mesh>([key, store = workbench_.models()] { return store->mesh(key.file); },
                       [this](const Mesh& mesh) {
                           if (mesh != mesh_)
                               chosen_.clear();
                           mesh_ = mesh;
                           refreshChosen();
                       },
                       [this](const std::exception_ptr& thrown) {
                           mesh_ = nullptr;
                           chosen_.clear();
                           refreshChosen();
                           dialogs_.tell(&dock_, tr("The faces of the model cannot be read"),
                                         sentencesOf(thrown));
                       });
    fillBoxes();
    refreshChosen();
    refreshCodes();
}

void FacePainter::showPaint(const std::filesystem::path& file) {
    std::set<ModelKey> keys;
    for (const DisplayModel& model : view_.scene().models)
        if (model.key.file == file)
            keys.insert(model.key);
    if (keys.empty())
        return;
    struct Made {
        ModelKey key;
        std::shared_ptr<const irsg::Model> model;
        std::shared_ptr<const ModelFaces> faces;
    };
    auto& task = paints_[file];
    if (!task)
        task = std::make_unique<LatestTask>();
    task->run<std::vector<Made>>(
        [keys, store = workbench_.models()] {
            std::vector<Made> all;
            for (const ModelKey& key : keys) {
                auto model = store->model(key);
                auto faces = std::make_shared<const ModelFaces>(*model);
                all.push_back({key, std::move(model), std::move(faces)});
            }
            return all;
        },
        [this](const std::vector<Made>& all) {
            for (const Made& made : all)
                view_.setModel(made.key, made.model, made.faces);
            fillBoxes();
            refreshCodes();
        },
        [this](const std::exception_ptr& thrown) {
            dialogs_.tell(&dock_, tr("The painted model cannot be shown"), sentencesOf(thrown));
        });
}

bool FacePainter::click(const QPointF& point, Qt::KeyboardModifiers modifiers, PickBy by) {
    const auto painted = model();
    if (!isActive_ || !mesh_ || !painted)
        return false;
    const irsg::Pose& pose = shown()->pose;
    const irsg::Rotation toModel = pose.attitude.rotation().transposed();
    const ViewProjection through = view_.projection();
    const osg::Matrixd toFile = osg::Matrixd::inverse(irsg::toOsg(painted->fromFile()));
    const osg::Vec3d eye =
        irsg::toOsg(toModel * (through.eye.position_m - pose.position_m)) * toFile;
    const osg::Vec3d along =
        osg::Matrixd::transform3x3(irsg::toOsg(toModel * through.ray(point)), toFile);
    const auto face = irsg::faceAlong(*mesh_, irsg::fromOsg(eye), irsg::fromOsg(along));
    const auto how = choosingBy(modifiers);
    if (!face) {
        if (how == irsg::Choosing::anew)
            choose({});
        return true;
    }
    choose(by == PickBy::part       ? irsg::partOf(*mesh_, *face)
           : by == PickBy::material ? irsg::sameMaterialAs(*mesh_, *face)
           : by == PickBy::angle    ? irsg::smoothFrom(*mesh_, *face, dock_.angle_rad())
                                    : irsg::FaceNumbers{*face},
           how);
    return true;
}

void FacePainter::takeBox(const QRectF& box, Qt::KeyboardModifiers modifiers) {
    const auto painted = model();
    if (!isActive_ || !mesh_ || !painted)
        return;
    const irsg::Pose& pose = shown()->pose;
    const ViewProjection through = view_.projection();
    irsg::FaceBox wanted;
    wanted.toPicture = painted->fromFile() * pictureOf(through, pose);
    wanted.eye = irsg::fromOsg(irsg::toOsg(pose.attitude.rotation().transposed() *
                                           (through.eye.position_m - pose.position_m)) *
                               osg::Matrixd::inverse(irsg::toOsg(painted->fromFile())));
    wanted.left = box.left();
    wanted.top = box.top();
    wanted.right = box.right();
    wanted.bottom = box.bottom();
    wanted.hiddenToo = dock_.takesHidden();
    choose(irsg::facesIn(*mesh_, wanted), choosingBy(modifiers));
}

void FacePainter::choose(const irsg::FaceNumbers& faces, irsg::Choosing how) {
    chosen_ = irsg::chosen(chosen_, faces, how);
    refreshChosen();
}

void FacePainter::chooseIndex(int index) {
    if (!mesh_)
        return;
    try {
        const auto codes = mesh_->codes(*workbench_.painted().of(key_.file));
        irsg::FaceNumbers faces;
        for (unsigned int f = 0; f < codes.size(); ++f)
            if ((dock_.shown() == CodesShown::material ? codes[f].material
                                                       : codes[f].temperature) == index)
                faces.push_back(f);
        choose(faces);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(&dock_, tr("The codes beside the model"), sentencesOf(error));
    }
}

void FacePainter::paint(bool erase) {
    if (!mesh_ || chosen_.empty())
        return;
    try {
        const auto before = workbench_.painted().of(key_.file);
        const auto count = static_cast<int>(chosen_.size());
        const QString faces = count == 1 ? tr("1 face") : tr("%1 faces").arg(count);
        if (erase)
            workbench_.painted().edit(key_.file, irsg::erased(*before, *mesh_, chosen_),
                                      tr("Erase %1").arg(faces));
        else
            workbench_.painted().edit(key_.file,
                                      irsg::painted(*before, *mesh_, chosen_, dock_.codes()),
                                      tr("Paint %1").arg(faces));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(&dock_, tr("This model cannot be painted"), sentencesOf(error));
    }
}

void FacePainter::addEntry(EntryKind kind) {
    auto& session = workbench_.database();
    const auto painted = model();
    if (!session.isOpen() || !painted)
        return;
    // One that no face has yet, so that nothing else becomes of it.
    const bool isMaterial = kind == EntryKind::material;
    const auto isUsed = [&](int index) {
        return std::ranges::any_of(painted->codes(), [&](const auto& use) {
            return (isMaterial ? use.first.material : use.first.temperature) == index;
        });
    };
    int index = freeIndex(session.value(), kind);
    while (isUsed(index))
        index = freeIndex(session.value(), kind, index + 1);
    NewEntryDialog dialog(kind, index, &dock_);
    if (!dialogs_.run(dialog))
        return;
    session.edit((isMaterial ? tr("Add material %1") : tr("Add temperature %1")).arg(index),
                 [&](irsg::SignatureDatabase& database) {
                     if (isMaterial) {
                         database.materials[index].name = dialog.name();
                         return;
                     }
                     irsg::TemperatureEntry& entry = database.temperatures[index];
                     entry.name = dialog.name();
                     entry.terms = irsg::TemperatureTerms::ofAmbient();
                 });
    (isMaterial ? dock_.material() : dock_.temperature()).setIndex(index);
    openEntry_({kind, index});
}

const irsg::SignatureDatabase* FacePainter::database() const {
    if (workbench_.database().isOpen())
        return &workbench_.database().value();
    return shown() != nullptr ? shown()->signature.get() : nullptr;
}

std::string FacePainter::nameOf(EntryKind kind, int index) const {
    const auto* entries = database();
    if (entries == nullptr)
        return {};
    if (kind == EntryKind::material) {
        const auto found = entries->materials.find(index);
        return found == entries->materials.end() ? std::string() : found->second.name;
    }
    const auto found = entries->temperatures.find(index);
    return found == entries->temperatures.end() ? std::string() : found->second.name;
}

void FacePainter::fillBoxes() {
    std::map<int, std::string> temperatures, materials;
    if (const auto* entries = database()) {
        for (const auto& [index, entry] : entries->temperatures)
            temperatures[index] = entry.name;
        for (const auto& [index, entry] : entries->materials)
            materials[index] = entry.name;
    }
    if (const auto painted = model())
        for (const auto& [codes, use] : painted->codes()) {
            temperatures.try_emplace(codes.temperature);
            materials.try_emplace(codes.material);
        }
    const bool mayAdd = workbench_.database().isOpen();
    dock_.temperature().setEntries(temperatures, mayAdd);
    dock_.material().setEntries(materials, mayAdd);
}

void FacePainter::refreshChosen() {
    const auto painted = model();
    if (!mesh_ || !painted) {
        view_.setChosen({});
        dock_.setChosen(0, 0.0,
                        reading_.isBusy()    ? tr("Reading the faces…")
                        : shown() == nullptr ? tr("No model is open")
                                             : tr("The faces of this model cannot be read"));
        return;
    }
    double area = 0.0;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const unsigned int f : chosen_) {
        const auto& face = mesh_->faces()[f];
        area += face.area;
        for (const auto& triangle : mesh_->trianglesOf(face))
            for (const irsg::Vec3& corner : triangle)
                corners->push_back(irsg::toOsg(painted->fromFile().place(corner)));
    }
    const double unit = unitOf(painted->fromFile());
    dock_.setChosen(chosen_.size(), area * unit * unit);
    ChosenFaces marked{.model = number_, .geometry = {}};
    if (!chosen_.empty()) {
        marked.geometry = new osg::Geometry;
        marked.geometry->setUseDisplayList(false);
        marked.geometry->setUseVertexBufferObjects(true);
        marked.geometry->setVertexArray(corners);
        marked.geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(corners->size())));
    }
    view_.setChosen(marked);
}

void FacePainter::refreshCodes() {
    const auto painted = model();
    if (!isActive_ || !painted || dock_.shown() == CodesShown::none) {
        view_.setCodeColors(nullptr);
        dock_.setLegend({});
        return;
    }
    const bool byMaterial = dock_.shown() == CodesShown::material;
    std::map<int, irsg::CodeUse> uses;
    for (const auto& [codes, use] : painted->codes()) {
        auto& sum = uses[byMaterial ? codes.material : codes.temperature];
        sum.faces += use.faces;
        sum.area_m2 += use.area_m2;
    }
    // An index keeps the colour that it got first; after the eighth they come lighter and darker.
    auto& colors = colors_[byMaterial ? 1 : 0];
    const PlotStyle style = PlotStyle::screen(dock_.palette());
    std::vector<CodeRow> rows;
    for (const auto& [index, use] : uses) {
        if (!colors.contains(index)) {
            const int place = static_cast<int>(colors.size());
            const QColor color = style.curve(place);
            colors[index] = place / 8 % 3 == 0   ? color
                            : place / 8 % 3 == 1 ? color.lighter(150)
                                                 : color.darker(165);
        }
        rows.push_back({index,
                        QString::fromStdString(nameOf(
                            byMaterial ? EntryKind::material : EntryKind::temperature, index)),
                        colors[index], use.faces, use.area_m2});
    }
    dock_.setLegend(rows);
    view_.setCodeColors(std::make_shared<const CodeColors>(CodeColors{byMaterial, colors}));
}

} // namespace smat::gui

#include "moc_FacePainter.cpp"
