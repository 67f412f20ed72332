/**
 * Browser tests of each folder of sources, for `npm run try`: a file goes by the first row whose folder holds it. Each row
 * names few files, the quickest that fail when what the folder holds is broken.
 *
 * @type {readonly (readonly [folder: string, specs: readonly string[]])[]}
 */
export const subjects = [
  ['packages/renderer/src/adapters', ['examples/passes', 'examples/drei']],
  ['packages/renderer/src/authoring', ['render/errors', 'render/effects']],
  ['packages/renderer/src/effects/ambient-occlusion', ['render/ambientOcclusion']],
  ['packages/renderer/src/effects/antialiasing', ['render/antialiasing']],
  ['packages/renderer/src/effects/decals', ['render/decals']],
  ['packages/renderer/src/effects/light-probes', ['render/bake']],
  ['packages/renderer/src/effects/particles', ['render/particles']],
  ['packages/renderer/src/effects/transparency', ['render/transparency']],
  ['packages/renderer/src/effects/volumetric-fog', ['render/volumetricFog']],
  ['packages/renderer/src/effects', ['render/effects']],
  ['packages/renderer/src/light-fields', ['render/lightField']],
  ['packages/renderer/src/light-profiles', ['render/lightProfiles']],
  ['packages/renderer/src/lighting/area-lights', ['render/areaLights']],
  ['packages/renderer/src/materials/gouraud', ['render/shading']],
  ['packages/renderer/src/microshaders', ['render/microshaders', 'render/claims', 'render/toon']],
  ['packages/renderer/src/pixel-lighting', ['render/pixelLighting']],
  ['packages/renderer/src/renderer/budget', ['render/budget', 'perf/frameBudget']],
  ['packages/renderer/src/renderer/learning', ['perf/autoChange']],
  ['packages/renderer/src/renderer/timer', ['perf/draws']],
  ['packages/renderer/src/renderer/warm-up', ['render/lazyCode']],
  ['packages/renderer/src/renderer/xr', ['render/xr']],
  ['packages/renderer/src/shadows', ['render/shadows', 'render/shadowMaps']],
  ['packages/renderer/src/surfaces', ['render/surfaces']],
  ['packages/renderer/src/techniques/light-buffer', ['render/inferred', 'render/toon']],
  ['packages/renderer/src/techniques/multipass', ['render/sharedMaterial', 'render/glass']],
  ['packages/renderer/src/three/nodes', ['render/nodeMaterials']],
  ['packages/renderer/src/views', ['viewer/gui']],
  ['packages/renderer', ['render/agreement', 'render/claims', 'render/host', 'perf/cpuCounts']],

  ['packages/bake', ['render/bake']],

  ['packages/engine/src/animation', ['editor/timeline']],
  ['packages/engine/src/audio', []], // held by unit tests alone
  ['packages/engine/src/components', ['editor/components']],
  ['packages/engine/src/files', ['editor/files']],
  ['packages/engine/src/physics', ['editor/physics']],
  ['packages/engine/src/picture', ['editor/picture']],
  ['packages/engine/src/prefabs', ['editor/files']],
  ['packages/engine/src/profiles', ['editor/profiles']],
  ['packages/scenes', ['render/everyScene']],
  ['packages/engine/src/scripts', ['editor/scripts']],
  ['packages/engine', ['editor/journey', 'viewer/url']],

  ['packages/editing', ['editor/fields', 'examples/attach']],
  ['packages/attach', ['examples/attach']],
  ['packages/create-farol', []], // held by unit tests alone
  ['packages/mcp', ['editor/agent']],
  ['packages/tools', []], // held by unit tests alone

  ['apps/site/live/thesis', ['thesis/thesis']],
  ['apps/site/live', ['gallery/gallery']],
  ['apps/site', []], // held by the site's own tests, not by browser specs
  ['apps/viewer', ['viewer/url', 'viewer/gui']],
  ['apps/lab/src/charts', ['lab/charts']],
  ['apps/lab/src/results', ['lab/keeping']],
  ['apps/lab/src/run', ['lab/keeping']],
  ['apps/lab', ['lab/journey']],

  ['apps/editor/src/agent', ['editor/agent']],
  ['apps/editor/src/fields', ['editor/fields', 'editor/inspector']],
  ['apps/editor/src/language', ['editor/language']],
  ['apps/editor/src/layout', ['editor/layout']],
  ['apps/editor/src/microshaders', ['editor/microshaders']],
  ['apps/editor/src/player', ['editor/scripts']],
  ['apps/editor/src/plugins', ['editor/plugin']],
  ['apps/editor/src/samples', ['editor/welcome']],
  ['apps/editor/src/scripts', ['editor/scriptsPanel']],
  ['apps/editor/src/viewport', ['editor/viewport']],
  ['apps/editor/src/files/autosave', ['editor/drafts']],
  ['apps/editor/src/files/library', ['editor/library']],
  ['apps/editor/src/files', ['editor/assets']],
  ['apps/editor/src/model/library', ['editor/library']],
  ['apps/editor/src/panels/agent', ['editor/agent']],
  ['apps/editor/src/panels/assets', ['editor/assets']],
  ['apps/editor/src/panels/bake', ['editor/bake']],
  ['apps/editor/src/panels/dialogs', ['editor/welcome']],
  ['apps/editor/src/panels/frame', ['editor/frame']],
  ['apps/editor/src/panels/hierarchy', ['editor/hierarchy']],
  ['apps/editor/src/panels/lights', ['editor/lights']],
  ['apps/editor/src/panels/history', ['editor/layout']],
  ['apps/editor/src/panels/inspector', ['editor/inspector', 'editor/fields']],
  ['apps/editor/src/panels/keys', ['editor/commands']],
  ['apps/editor/src/panels/library', ['editor/library']],
  ['apps/editor/src/panels/material', ['editor/materials']],
  ['apps/editor/src/panels/microshaders', ['editor/microshaders']],
  ['apps/editor/src/panels/palette', ['editor/commands']],
  ['apps/editor/src/panels/play', ['editor/play']],
  ['apps/editor/src/panels/prefab', ['editor/files']],
  ['apps/editor/src/panels/scripts', ['editor/scriptsPanel']],
  ['apps/editor/src/panels/timeline', ['editor/timeline']],
  ['apps/editor/src/panels/tour', ['editor/welcome']],
  ['apps/editor/src/panels/viewport', ['editor/viewport']],
  ['apps/editor/src/panels/welcome', ['editor/welcome']],
  ['apps/editor', ['editor/journey']],

  ['e2e', []], // a changed spec runs itself
];

/**
 * Browser tests of components that have some of their own, by the beginnings of paths.
 *
 * @type {readonly (readonly [start: string, spec: string])[]}
 */
export const components = Object.entries({
  'editor/areaLights': ['Light', 'SkyLight', 'applyLightFields', 'lightFields', 'newLights', 'newShadows'],
  'editor/assets': ['ModelRenderer', 'importModel', 'objectsOfModel'],
  'editor/morphTargets': ['MorphTargets'],
  'editor/newcomer': ['Room', 'Wall', 'shapeComponent'],
  'editor/particles': ['ParticleEmitter', 'particle'],
  'editor/physics': ['Collider', 'Joint', 'RigidBody'],
  'editor/timeline': ['Animation', 'Animator'],
  'editor/touch': ['CharacterController', 'TouchStick'],
  'editor/viewport': ['Camera'],
}).flatMap(([spec, names]) => names.map((name) => [`packages/engine/src/components/${name}`, spec]));

/**
 * @param {string} path - of a source file, from the repository's root, with `/`
 * @returns {readonly string[]} paths of the specs of its subject; empty where it has none
 */
export function specsOf(path) {
  if (path.endsWith('.spec.ts')) return [path];
  const component = components.find(([start]) => path.startsWith(start));
  if (component) return [`e2e/${component[1]}.spec.ts`];
  const row = subjects.find(([folder]) => path.startsWith(`${folder}/`));
  return (row?.[1] ?? []).map((name) => `e2e/${name}.spec.ts`);
}
