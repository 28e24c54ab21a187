#include "engine/base/hdf5.h"

#include <atomic>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "engine/base/hdf5_library_reader.h"

namespace plumb::hdf5 {
namespace {

/// An identifier with the function that closes it.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error(what);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error(what);
}

void silence() {
  // What it would tidy up at the end is the system's by then, and where memory had run out it crashes over
  // it.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle string_type(H5T_cset_t characters = H5T_CSET_UTF8) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot make a string type");
  require(H5Tset_size(type, H5T_VARIABLE), "cannot make a string type");
  require(H5Tset_cset(type, characters), "cannot make a string type");
  return type;
}

/// A name for a file in memory. The library takes two open ones of the same name for the same file.
std::string memory_name() {
  static std::atomic<long> count = 0;
  return "memory-" + std::to_string(++count);
}

Handle space_of(const std::vector<hsize_t>& shape) {
  return {shape.empty() ? H5Screate(H5S_SCALAR)
                        : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
          H5Sclose, "cannot make a data space"};
}

hsize_t count_of(const std::vector<hsize_t>& shape) {
  // More than any memory holds, and few enough that no size in bytes overflows.
  constexpr hsize_t most = hsize_t{1} << 48U;
  hsize_t count = 1;
  for (const hsize_t extent : shape) {
    if (extent > 0 && count > most / extent) throw std::runtime_error("a data set in it is too large");
    count *= extent;
  }
  return count;
}

/// The library does not bear that memory runs out within it: so much is asked for and given back before.
/// Throws std::bad_alloc.
void must_have_room(std::size_t bytes) {
  constexpr std::size_t own_needs = 4 << 20;
  const std::unique_ptr<char[]> room(new char[bytes + own_needs]);
  // Not to be left out.
  static_cast<volatile char*>(room.get())[0] = 0;
}

/// Calls what makes a part of a file in memory, which fails for want of memory alone. Throws std::bad_alloc.
template <class Make>
auto make_in_memory(Make make) {
  try {
    return make();
  } catch (const std::runtime_error&) {
    throw std::bad_alloc();
  }
}

void write(hid_t file, const std::string& path, hid_t type, const std::vector<hsize_t>& shape,
           const void* values, std::string_view unit) {
  const Handle space = space_of(shape);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, path);
  require(H5Pset_create_intermediate_group(links, 1), path);
  // The same content is the same bytes whenever it is written.
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  require(H5Pset_obj_track_times(creation, false), path);
  const Handle set(H5Dcreate2(file, path.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose,
                   "cannot make " + path);
  if (count_of(shape) > 0)
    require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "cannot write " + path);
  const Handle unit_type = string_type(), one = space_of({});
  const Handle attribute(H5Acreate2(set, "unit", unit_type, one, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, path);
  const std::string terminated(unit);
  const char* pointer = terminated.c_str();
  require(H5Awrite(attribute, unit_type, &pointer), "cannot write the unit of " + path);
}

struct OpenSet {
  Handle set;
  std::vector<hsize_t> shape;
};

OpenSet open(hid_t file, const std::string& path, H5T_class_t expected) {
  Handle set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "the data set " + path + " is missing");
  const Handle type(H5Dget_type(set), H5Tclose, path);
  if (H5Tget_class(type) != expected)
    throw std::runtime_error("the data set " + path + " is of another type");
  const Handle space(H5Dget_space(set), H5Sclose, path);
  const int rank = H5Sget_simple_extent_ndims(space);
  require(rank, path);
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  require(H5Sget_simple_extent_dims(space, shape.data(), nullptr), path);
  return {std::move(set), std::move(shape)};
}

}  // namespace

Writer::Writer() {
  must_have_room(0);
  silence();
  make_in_memory([this] { open_empty(); });
}

void Writer::open_empty() {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot make a file in memory");
  constexpr std::size_t growth = 1 << 20;
  require(H5Pset_fapl_core(access, growth, false), "cannot make a file in memory");
  file_ = H5Fcreate(memory_name().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  require(static_cast<herr_t>(file_ < 0 ? -1 : 0), "cannot make a file in memory");
}

Writer::~Writer() {
  H5Fclose(file_);
}

void Writer::numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                     std::string_view unit) {
  must_have_room(2 * sizeof(double) * count_of(shape));
  make_in_memory([&] { write(file_, path, H5T_NATIVE_DOUBLE, shape, values, unit); });
}

void Writer::integer(const std::string& path, long value) {
  make_in_memory([&] { write(file_, path, H5T_NATIVE_LONG, {}, &value, "1"); });
}

void Writer::integers(const std::string& path, const std::vector<long>& values,
                      const std::vector<hsize_t>& shape) {
  must_have_room(2 * sizeof(long) * values.size());
  make_in_memory([&] { write(file_, path, H5T_NATIVE_LONG, shape, values.data(), "1"); });
}

void Writer::put_attribute(const std::string& group, const std::string& name, hid_t type,
                           const std::vector<hsize_t>& shape, const void* values) {
  const Handle opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, group), space = space_of(shape);
  const Handle attribute(H5Acreate2(opened, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         group);
  require(H5Awrite(attribute, type, values), "cannot write the attribute " + name);
}

void Writer::attribute(const std::string& group, const std::string& name, long value) {
  make_in_memory([&] { put_attribute(group, name, H5T_NATIVE_LONG, {}, &value); });
}

void Writer::attribute(const std::string& group, const std::string& name, const std::vector<long>& values) {
  make_in_memory([&] { put_attribute(group, name, H5T_NATIVE_LONG, {values.size()}, values.data()); });
}

void Writer::attribute(const std::string& group, const std::string& name, std::string_view value) {
  make_in_memory([&] {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot make a string type");
    require(H5Tset_size(type, value.size()), "cannot make a string type");
    require(H5Tset_strpad(type, H5T_STR_NULLPAD), "cannot make a string type");
    put_attribute(group, name, type, {}, std::string(value).data());
  });
}

void Writer::text(const std::string& path, std::string_view value) {
  const std::string terminated(value);
  const char* pointer = terminated.c_str();
  make_in_memory([&] { write(file_, path, string_type(), {}, &pointer, "text"); });
}

void Writer::texts(const std::string& path, const std::vector<std::string>& values) {
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  make_in_memory([&] { write(file_, path, string_type(), {values.size()}, pointers.data(), "text"); });
}

void Writer::bytes(const std::string& path, std::string_view value) {
  make_in_memory([&] { write(file_, path, H5T_NATIVE_UCHAR, {value.size()}, value.data(), "bytes"); });
}

std::string Writer::bytes() {
  // So that a check sum can be added without a copy.
  constexpr std::size_t room = 64;
  return make_in_memory([&] {
    require(H5Fflush(file_, H5F_SCOPE_GLOBAL), "cannot finish the file");
    const auto size = H5Fget_file_image(file_, nullptr, 0);
    if (size < 0) throw std::runtime_error("cannot finish the file");
    std::string image;
    image.reserve(static_cast<std::size_t>(size) + room);
    image.resize(static_cast<std::size_t>(size));
    if (H5Fget_file_image(file_, image.data(), image.size()) != size)
      throw std::runtime_error("cannot finish the file");
    return image;
  });
}

LibraryReader::LibraryReader(const std::string& bytes) {
  silence();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot open a file in memory");
  constexpr std::size_t growth = 1 << 20;
  require(H5Pset_fapl_core(access, growth, false), "cannot open a file in memory");
  // The library takes a copy and does not write to what it is given.
  require(H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size()), "it is no HDF5 file");
  file_ = H5Fopen(memory_name().c_str(), H5F_ACC_RDONLY, access);
  if (file_ < 0) throw std::runtime_error("it is no HDF5 file");
}

LibraryReader::~LibraryReader() {
  H5Fclose(file_);
}

bool LibraryReader::has(const std::string& path) const {
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', end + 1))
    if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0;
}

Numbers LibraryReader::numbers(const std::string& path) const {
  OpenSet opened = open(file_, path, H5T_FLOAT);
  Numbers result{std::move(opened.shape), {}};
  result.values.resize(count_of(result.shape));
  if (!result.values.empty())
    require(H5Dread(opened.set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data()),
            "the data set " + path + " cannot be read");
  return result;
}

std::vector<double> LibraryReader::numbers(const std::string& path, const std::vector<hsize_t>& shape) const {
  if (open(file_, path, H5T_FLOAT).shape != shape)
    throw std::runtime_error("the data set " + path + " is not of the shape that the others call for");
  return numbers(path).values;
}

std::vector<long> LibraryReader::integers(const std::string& path) const {
  const OpenSet opened = open(file_, path, H5T_INTEGER);
  std::vector<long> values(count_of(opened.shape));
  if (!values.empty())
    require(H5Dread(opened.set, H5T_NATIVE_LONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "the data set " + path + " cannot be read");
  return values;
}

std::vector<std::string> LibraryReader::texts(const std::string& path) const {
  const OpenSet opened = open(file_, path, H5T_STRING);
  const Handle type = string_type(), space = space_of(opened.shape);
  std::vector<char*> pointers(count_of(opened.shape));
  if (pointers.empty()) return {};
  require(H5Dread(opened.set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()),
          "the data set " + path + " cannot be read");
  std::vector<std::string> values;
  for (const char* pointer : pointers) values.emplace_back(pointer ? pointer : "");
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  return values;
}

std::string LibraryReader::bytes(const std::string& path) const {
  const OpenSet opened = open(file_, path, H5T_INTEGER);
  if (opened.shape.size() != 1) throw std::runtime_error("the data set " + path + " is not a row of bytes");
  // What is packed may claim to be any size.
  constexpr hsize_t longest = 256 * 1024 * 1024;
  if (opened.shape.front() > longest) throw std::runtime_error("the data set " + path + " is too long");
  std::string value(opened.shape.front(), '\0');
  if (!value.empty())
    require(H5Dread(opened.set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()),
            "the data set " + path + " cannot be read");
  return value;
}

namespace {

/// Where `series` collects what it visits.
struct Visit {
  hid_t file;
  std::vector<std::string> paths;
};

herr_t visit(hid_t, const char* name, const H5O_info_t* info, void* data) {
  constexpr std::size_t most_paths = 10'000;
  auto& found = *static_cast<Visit*>(data);
  if (info->type != H5O_TYPE_DATASET) return 0;
  try {
    const std::string path = name;
    const Handle set(H5Dopen2(found.file, name, H5P_DEFAULT), H5Dclose, path);
    const Handle type(H5Dget_type(set), H5Tclose, path), space(H5Dget_space(set), H5Sclose, path);
    const H5T_class_t kind = H5Tget_class(type);
    if ((kind == H5T_FLOAT || kind == H5T_INTEGER) && H5Sget_simple_extent_ndims(space) == 1)
      found.paths.push_back(path);
  } catch (const std::runtime_error&) {
    return 0;  // a data set that cannot be opened is none
  }
  return found.paths.size() < most_paths ? 0 : 1;
}

}  // namespace

std::vector<std::string> LibraryReader::series() const {
  Visit found{file_, {}};
  require(H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_INC, visit, &found, H5O_INFO_BASIC),
          "its data sets cannot be listed");
  return found.paths;
}

std::vector<double> LibraryReader::series_values(const std::string& path, hsize_t most) const {
  const Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "the data set is missing");
  const Handle space(H5Dget_space(set), H5Sclose, path);
  hsize_t count = 0;
  if (H5Sget_simple_extent_ndims(space) != 1)
    throw std::runtime_error("the data set is not of one dimension");
  require(H5Sget_simple_extent_dims(space, &count, nullptr), path);
  if (count > most)
    throw std::runtime_error(std::to_string(count) + " rows are more than the " + std::to_string(most) +
                             " that are read");
  std::vector<double> values(count);
  if (!values.empty())
    require(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "the data set cannot be read");
  return values;
}

std::string LibraryReader::unit(const std::string& path) const {
  constexpr std::size_t longest = 100;
  const Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "the data set is missing");
  if (H5Aexists(set, "unit") <= 0) return "";
  const Handle attribute(H5Aopen(set, "unit", H5P_DEFAULT), H5Aclose, path);
  const Handle type(H5Aget_type(attribute), H5Tclose, path), space(H5Aget_space(attribute), H5Sclose, path);
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1)
    throw std::runtime_error("the unit of " + path + " is not one text");
  if (H5Tis_variable_str(type) > 0) {
    const Handle as = string_type(H5Tget_cset(type));
    char* pointer = nullptr;
    require(H5Aread(attribute, as, &pointer), "the unit of " + path + " cannot be read");
    std::string unit = pointer != nullptr ? std::string(pointer).substr(0, longest) : "";
    H5Dvlen_reclaim(as, space, H5P_DEFAULT, &pointer);
    return unit;
  }
  const std::size_t size = H5Tget_size(type);
  if (size > longest) throw std::runtime_error("the unit of " + path + " is too long");
  std::string unit(size, '\0');
  require(H5Aread(attribute, type, unit.data()), "the unit of " + path + " cannot be read");
  // Padded by blanks or 0 bytes.
  unit.resize(std::min(unit.find('\0'), unit.size()));
  unit.resize(unit.find_last_not_of(' ') + 1);
  return unit;
}

}  // namespace plumb::hdf5
