import type { TechniqueName } from '@farol/renderer';
import type { LightFacts, MaterialFacts, SceneFacts, ThingFacts } from './SceneFacts';

/** A part of scenes that is taken out before they are drawn. */
interface LeftOut {
  readonly what: string;
  readonly why: string;
  readonly from: (facts: SceneFacts) => SceneFacts;
}

/** Kinds of objects whose geometry has no normals. */
const withoutNormals = ({ as, traits = [] }: ThingFacts) =>
  as === 'sprite' || as === 'segments' || traits.includes('without normals');

/** A material without the anisotropy of a wireframe. */
function plainWires(material: MaterialFacts = {}): MaterialFacts {
  if (material.wireframe !== true) return material;
  const { anisotropy: _amount, anisotropyMap: _map, anisotropyRotation: _angle, ...plain } = material;
  return plain;
}

/** A material that lets no light through. */
function shut({ transmission: _amount, transmissionMap: _map, ...material }: MaterialFacts): MaterialFacts {
  return material;
}

const isThin = /points|line|loop|segments/;
const isAround = (background: unknown) => background === 'cube' || background === 'equirect';

/** Scenes that are not compared, since stock three's own picture of them is not defined: a line for each. */
export const leftOut: readonly LeftOut[] = [
  {
    what: 'a lit material of the scene (overrideMaterial) for sprites and other things without normals',
    why: 'normals are what the device has for an attribute that is not there, and of the length 0',
    from: ({ world: { override, ...world } = {}, ...facts }) =>
      override && facts.things?.some(withoutNormals)
        ? { ...facts, world }
        : { ...facts, world: { ...world, override } },
  },
  {
    what: 'transmission of the material of the scene (overrideMaterial)',
    why: 'three throws: it makes the target of what is behind glass for objects whose own material transmits',
    from: ({ world: { override, ...world } = {}, ...facts }) => ({
      ...facts,
      world: override ? { ...world, override: shut(override) } : world,
    }),
  },
  {
    what: 'anisotropy of a wireframe',
    why: 'tangents come from derivatives across a line, which has no width: pixels of stock three are not finite',
    from: ({ things = [], world: { override, ...world } = {}, ...facts }) => ({
      ...facts,
      things: things.map((thing) => (thing.material ? { ...thing, material: plainWires(thing.material) } : thing)),
      world: override ? { ...world, override: plainWires(override) } : world,
    }),
  },
  {
    what: 'a background all round, seen by an orthographic camera',
    why: 'it is a cube of 2 units: beside it shows the colour that the last shadow map was cleared to',
    from: ({ world: { background, ...world } = {}, ...facts }) =>
      facts.view?.camera === 'orthographic' && isAround(background)
        ? { ...facts, world }
        : { ...facts, world: { ...world, background } },
  },
  {
    what: 'shadows of points and lines',
    why: 'shadow maps write no gl_PointSize; which texels a line covers depends on the direction that a face is drawn in',
    from: ({ things = [], ...facts }) => ({
      ...facts,
      things: things.map((thing) => (isThin.test(thing.as ?? '') ? { ...thing, castShadow: false } : thing)),
    }),
  },
  {
    what: 'one polygon of 40 m and more round the camera (chooseRoom divides such floors)',
    why: 'the device moves what it interpolates: 100 m are at 52 dB to the exact picture, and divided by 40 at 73 dB',
    from: (facts) => facts,
  },
  {
    what: 'cameras of an array whose viewports leave a part of the picture out, or overlap (buildScene makes none)',
    why: 'what is left out has the colour that the last shadow map was cleared to, and depth is not cleared between them',
    from: (facts) => facts,
  },
  {
    what: 'the first picture of an array camera (compareScene draws one before)',
    why: "three makes a scene's environment while it draws the first camera, and then goes on over the whole canvas",
    from: (facts) => facts,
  },
];

/** Takes out of a scene all that is {@link leftOut}. */
export const leaveOut = (facts: SceneFacts): SceneFacts => leftOut.reduce((left, { from }) => from(left), facts);

const ownLights: readonly (keyof LightFacts)[] = ['profile', 'cookie', 'shape', 'castShadow'];
/** Techniques that have normals for AmbientOcclusion: `forward-plus` takes them from depth. */
const withNormals = ['clustered-deferred', 'deferred', 'tiled-deferred', 'light-prepass', 'inferred'];

/** With what a scene's pictures are compared, null for stock three, and which techniques can draw it. */
export function ownOf({ world = {}, lights = [] }: SceneFacts): {
  readonly reference: TechniqueName | null;
  readonly able: (technique: TechniqueName) => boolean;
} {
  const { effects = [], shadowCascades, lightLayers } = world;
  if (effects.includes('AmbientOcclusion'))
    return { reference: 'clustered-deferred', able: (name) => withNormals.includes(name) };
  const isOwn = lights.some((light) => ownLights.some((name) => light[name] !== undefined));
  const isStock = !isOwn && effects.length === 0 && !shadowCascades && !lightLayers;
  return { reference: isStock ? null : 'forward-single-pass', able: () => true };
}
