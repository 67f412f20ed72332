import * as THREE from 'three';
import type { Dice } from './Dice';
import type { Kind, MaterialFacts } from './SceneFacts';

type Facts = Record<string, unknown>;

const { AdditiveBlending, CustomBlending, MaxEquation, MultiplyBlending, NoBlending, SubtractiveBlending } = THREE;

/** Types of lit materials, those that people use most more often. */
const lit = [
  ...['MeshStandardMaterial', 'MeshStandardMaterial', 'MeshStandardMaterial', 'MeshLambertMaterial'],
  ...['MeshPhongMaterial', 'MeshPhysicalMaterial', 'MeshPhysicalMaterial', 'MeshToonMaterial'],
];
const unlit = ['MeshBasicMaterial', 'MeshMatcapMaterial', 'MeshNormalMaterial', 'unlit shader', 'raw shader'];

/** How a map of colours is laid over the surface: see `textureOf`. */
const looks = ['colour', 'colour', 'colour turned', 'colour nearest', 'colour uv1'];

const mapsOfAll: readonly ((facts: Facts, dice: Dice) => void)[] = [
  (facts, dice) => (facts.map = dice.of([...looks, 'bright'])),
  (facts, dice) => Object.assign(facts, { emissiveMap: dice.of(looks), emissive: dice.color() >> 1 }),
  (facts, dice) =>
    Object.assign(facts, { normalMap: 'normal', normalScale: [dice.between(0.2, 1), dice.between(-1, 1)] }),
  (facts) => Object.assign(facts, { normalMap: 'object normal', normalMapType: THREE.ObjectSpaceNormalMap }),
  (facts, dice) => Object.assign(facts, { bumpMap: 'grey', bumpScale: dice.between(0.5, 3) }),
  (facts, dice) =>
    Object.assign(facts, {
      displacementMap: 'grey',
      displacementScale: dice.between(0.05, 0.2),
      displacementBias: -0.1,
    }),
  (facts, dice) => Object.assign(facts, { aoMap: 'grey', aoMapIntensity: dice.between(0.3, 1) }),
  (facts, dice) => Object.assign(facts, { lightMap: 'colour', lightMapIntensity: dice.between(0.2, 1) }),
];

const mapsOf: Readonly<Record<string, typeof mapsOfAll>> = {
  MeshStandardMaterial: [
    (facts) => (facts.roughnessMap = 'grey'),
    (facts, dice) => Object.assign(facts, { metalnessMap: 'grey', metalness: dice.between(0.5, 1) }),
    (facts, dice) =>
      Object.assign(facts, {
        envMap: 'equirect',
        envMapIntensity: dice.between(0.3, 1.5),
        envMapRotation: dice.vector(1.5),
      }),
  ],
  MeshPhysicalMaterial: [
    (facts, dice) =>
      Object.assign(facts, { clearcoat: dice.between(0.3, 1), clearcoatRoughness: dice.between(0, 0.6) }),
    (facts) => Object.assign(facts, { clearcoat: 1, clearcoatNormalMap: 'normal', clearcoatRoughnessMap: 'grey' }),
    (facts, dice) =>
      Object.assign(facts, { sheen: 1, sheenColor: dice.color(), sheenRoughness: dice.between(0.2, 0.9) }),
    (facts) =>
      Object.assign(facts, { sheen: 1, sheenColor: 0xffffff, sheenColorMap: 'colour', sheenRoughnessMap: 'grey' }),
    (facts, dice) => Object.assign(facts, { iridescence: 1, iridescenceIOR: dice.between(1.1, 2) }),
    (facts) => Object.assign(facts, { iridescence: 1, iridescenceMap: 'grey', iridescenceThicknessMap: 'grey' }),
    (facts, dice) => Object.assign(facts, { anisotropy: dice.between(0.3, 1), anisotropyRotation: dice.between(0, 3) }),
    (facts) => Object.assign(facts, { anisotropy: 0.8, anisotropyMap: 'normal' }),
    (facts, dice) =>
      Object.assign(facts, {
        transmission: dice.between(0.3, 1),
        thickness: dice.between(0, 1),
        ior: dice.between(1, 2),
      }),
    (facts) => Object.assign(facts, { transmission: 1, transmissionMap: 'grey', thicknessMap: 'grey', thickness: 1 }),
    (facts) => Object.assign(facts, { transmission: 0.9, thickness: 0.8, dispersion: 4, roughness: 0 }),
    (facts, dice) => Object.assign(facts, { specularIntensity: dice.between(0, 1), specularColor: dice.color() }),
    (facts) => Object.assign(facts, { specularIntensityMap: 'grey', specularColorMap: 'colour' }),
  ],
  MeshPhongMaterial: [
    (facts) => Object.assign(facts, { specularMap: 'grey', specular: 0xffffff }),
    (facts, dice) =>
      Object.assign(facts, {
        envMap: dice.of(['cube', 'cube refracted']),
        combine: dice.of([THREE.MultiplyOperation, THREE.MixOperation, THREE.AddOperation]),
        reflectivity: dice.between(0.2, 0.8),
      }),
  ],
  MeshToonMaterial: [(facts) => (facts.gradientMap = 'steps')],
};

/** How a surface is drawn, whatever its type. */
const switches: readonly ((facts: Facts, dice: Dice) => void)[] = [
  (facts, dice) => (facts.side = dice.of([THREE.BackSide, THREE.DoubleSide, THREE.DoubleSide])),
  (facts) => (facts.flatShading = true),
  (facts) => (facts.wireframe = true),
  (facts) => (facts.vertexColors = true),
  (facts, dice) => Object.assign(facts, { transparent: true, opacity: dice.between(0.2, 0.9) }),
  (facts, dice) =>
    Object.assign(facts, { transparent: true, opacity: 0.6, side: THREE.DoubleSide, forceSinglePass: dice.in(0.5) }),
  (facts, dice) => Object.assign(facts, { transparent: dice.in(0.8), blending: AdditiveBlending }),
  (facts, dice) =>
    Object.assign(facts, {
      transparent: true,
      blending: dice.of([MultiplyBlending, SubtractiveBlending]),
      premultipliedAlpha: true,
    }),
  (facts) => Object.assign(facts, { transparent: true, blending: CustomBlending, blendEquation: MaxEquation }),
  (facts) => Object.assign(facts, { blending: NoBlending, opacity: 0.5 }),
  (facts) => Object.assign(facts, { transparent: true, opacity: 0.5, premultipliedAlpha: true }),
  (facts) => Object.assign(facts, { alphaMap: 'holes', alphaTest: 0.5 }),
  (facts) => Object.assign(facts, { alphaMap: 'holes', transparent: true }),
  (facts, dice) =>
    Object.assign(facts, { map: 'holes', alphaTest: 0.45, side: dice.of([THREE.FrontSide, THREE.DoubleSide]) }),
  (facts) => Object.assign(facts, { alphaHash: true, opacity: 0.5 }),
  (facts) => (facts.depthTest = false),
  (facts) => (facts.depthWrite = false),
  (facts, dice) => (facts.depthFunc = dice.of([THREE.GreaterDepth, THREE.LessDepth, THREE.AlwaysDepth])),
  (facts) => (facts.colorWrite = false),
  (facts, dice) =>
    Object.assign(facts, {
      polygonOffset: true,
      polygonOffsetFactor: dice.of([-2, -1, 1, 3]),
      polygonOffsetUnits: dice.of([-4, 0, 4]),
    }),
  (facts, dice) =>
    Object.assign(facts, {
      clippingPlanes: Array.from({ length: dice.whole(1, 2) }, () => [...dice.vector(1), dice.between(0, 1)]),
      clipIntersection: dice.in(0.3),
      clipShadows: dice.in(0.5),
      side: THREE.DoubleSide,
    }),
  (facts) => (facts.dithering = true),
  (facts) => (facts.fog = false),
  (facts) => (facts.toneMapped = false),
  (facts, dice) => (facts.shadowSide = dice.of([THREE.FrontSide, THREE.BackSide, THREE.DoubleSide])),
  (facts, dice) =>
    Object.assign(facts, {
      stencilWrite: true,
      stencilRef: 1,
      stencilFunc: dice.of([THREE.AlwaysStencilFunc, THREE.NotEqualStencilFunc, THREE.EqualStencilFunc]),
      stencilZPass: dice.of([THREE.KeepStencilOp, THREE.ReplaceStencilOp]),
    }),
  (facts, dice) => (facts.compile = dice.of(['waves', 'tint', 'stripes'])),
];

/** Switches that only materials with light on them have, or that shaders of one's own do not look at. */
const ofBuiltIns = /flatShading|alphaMap|alphaHash|compile|alphaTest|wireframe|vertexColors/;

function surface(facts: Facts, dice: Dice): void {
  if (facts.type === 'MeshPhongMaterial')
    Object.assign(facts, { specular: dice.color(), shininess: dice.whole(2, 80) });
  if (/Standard|Physical/.test(String(facts.type)))
    Object.assign(facts, { roughness: dice.between(0.15, 1), metalness: dice.of([0, 0, dice.between(0, 1), 1]) });
}

/** How a material of a lit mesh is made. */
function chooseLit(dice: Dice): Facts {
  const type = dice.of(lit);
  const facts: Facts = { type, color: dice.color() };
  surface(facts, dice);
  const own =
    type === 'MeshPhysicalMaterial' ? [...mapsOf[type], ...mapsOf.MeshStandardMaterial] : (mapsOf[type] ?? []);
  if (type === 'MeshPhysicalMaterial') dice.of(own)(facts, dice);
  // with the textures of lights and shadows a device of 16 units has room for few
  for (let left = dice.of([0, 0, 1, 1, 2, 3]); left > 0; left--) dice.of([...mapsOfAll, ...own])(facts, dice);
  return facts;
}

/** Chooses a material for a kind of object. */
export function chooseMaterial(dice: Dice, kind: Kind): MaterialFacts {
  const transparent = dice.in(0.3) ? { transparent: true, opacity: dice.between(0.3, 0.9) } : {};
  if (kind === 'points') {
    const size = dice.in(0.5) ? { size: dice.between(0.05, 0.2) } : { size: dice.whole(1, 6), sizeAttenuation: false };
    return {
      type: 'PointsMaterial',
      color: dice.color(),
      ...size,
      ...transparent,
      ...(dice.in(0.4) && { map: 'colour' }),
    };
  }
  if (kind === 'sprite') {
    const rotation = dice.between(0, 3);
    return {
      type: 'SpriteMaterial',
      color: dice.color(),
      rotation,
      ...transparent,
      ...(dice.in(0.5) && { map: 'holes' }),
    };
  }
  if (kind === 'line' || kind === 'loop' || kind === 'segments') {
    const dashed = dice.in(0.4) ? { dashSize: 0.1, gapSize: 0.06 } : {};
    const type = 'dashSize' in dashed ? 'LineDashedMaterial' : 'LineBasicMaterial';
    return { type, color: dice.color(), ...dashed, ...transparent, ...(dice.in(0.3) && { vertexColors: true }) };
  }
  const isLit = dice.in(0.85);
  const facts = isLit ? chooseLit(dice) : ({ type: dice.of(unlit), color: dice.color() } as Facts);
  if (facts.type === 'MeshBasicMaterial' && dice.in(0.5)) facts.map = 'colour';
  for (let left = dice.of([0, 1, 1, 2, 3]); left > 0; left--) {
    const asked: Facts = {};
    dice.of(switches)(asked, dice);
    if (isLit || !Object.keys(asked).some((name) => ofBuiltIns.test(name))) Object.assign(facts, asked);
  }
  return facts as MaterialFacts;
}
