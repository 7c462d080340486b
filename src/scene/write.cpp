#include "scene/describe.hpp"
#include "scene/describe_profile.hpp"
#include "scene/format.hpp"
#include "scene/read.hpp"
#include "scene/schema_builder.hpp"
#include "scene/tree.hpp"
#include "scene/writer.hpp"

namespace photic::scene {
namespace {

template <class Describe>
Node definition(const Describe& keys) {
  SchemaBuilder builder;
  PhaseFunction phase_function;
  keys(builder, phase_function);
  return builder.take();
}

template <class Form>
Node form_schema() {
  SchemaBuilder builder;
  Form form;
  describe(builder, form);
  return builder.take();
}

Node profile_schema() {
  Node schema = empty_table();
  schema.add("anyOf",
             {.value = Node::Array{form_schema<ProfilePoints>(), form_schema<ProfileFile>(),
                                   form_schema<ProfileModel>()}});
  return schema;
}

}  // namespace

Node tree_of(Scene scene) {
  Writer writer;
  describe(writer, scene);
  return writer.take();
}

std::string write_scene(const Scene& scene) { return format_toml(tree_of(scene)); }

std::string write_scene_json(const Scene& scene) { return format_json(tree_of(scene)); }

std::string scene_schema(const std::string& version) {
  Scene defaults;
  defaults.optics = optics_of(defaults.optics.set);
  SchemaBuilder builder;
  describe(builder, defaults);

  Node schema = empty_table();
  schema.add("$schema", to_node("https://json-schema.org/draft/2020-12/schema"));
  schema.add("$id", to_node("urn:photic:scene:" + version));
  schema.add("title", to_node("Photic scene"));
  schema.add("description",
             to_node("What a lidar over or in the sea is, what water it looks at, and how that is "
                     "simulated. Units are at the end of the keys' names; those of directions and "
                     "ratios are 1."));
  Node root = builder.take();
  for (Entry& entry : std::get<Node::Table>(root.value))
    schema.add(entry.key, std::move(entry.value));
  Node definitions = empty_table();
  definitions.add(SchemaBuilder::phase_function_name,
                  definition([](auto& v, PhaseFunction& p) { describe(v, p); }));
  definitions.add(SchemaBuilder::profile_name, profile_schema());
  definitions.add(SchemaBuilder::component_name,
                  definition([](auto& v, PhaseFunction& p) { describe_component(v, p); }));
  schema.add("$defs", std::move(definitions));
  return format_json(schema);
}

}  // namespace photic::scene
