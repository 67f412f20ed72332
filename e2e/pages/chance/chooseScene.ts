import type { MaterialFacts, SceneFacts, ThingFacts, ViewFacts, WorldFacts } from './SceneFacts';
import { chooseMaterial } from './chooseMaterial';
import { type LightPlan, placeLights, planLights } from './chooseLights';
import { chooseRoom, chooseTemplate, placeThing } from './chooseThing';
import { Dice } from './Dice';

/** Scenes in a row that have programs in common: to compile takes most of the time. */
export const DECK = 8;

/** Facts that all scenes of a deck share: those that decide upon their programs. */
interface Deck {
  readonly world: WorldFacts;
  readonly view: ViewFacts;
  readonly floor: ThingFacts;
  readonly templates: readonly ThingFacts[];
  readonly plans: readonly (readonly LightPlan[])[];
}

function chooseWorld(dice: Dice, own: boolean): WorldFacts {
  const fogged = dice.in(0.25);
  const fog = dice.in(0.5)
    ? { color: dice.color(), near: dice.between(2, 6), far: dice.between(8, 16) }
    : { color: dice.color(), density: dice.between(0.02, 0.15) };
  const effects = ['SMAA', 'AmbientOcclusion', 'WeightedBlendedOIT', 'MultisampledEdges'];
  return {
    ...(fogged && { fog }),
    ...(dice.in(0.4) && {
      environment: dice.of(['room', 'equirect', 'cube'] as const),
      environmentIntensity: dice.between(0.2, 1),
      ...(dice.in(0.5) && { environmentRotation: dice.vector(1) }),
    }),
    ...(dice.in(0.04) && { override: chooseMaterial(dice, 'mesh') as MaterialFacts }),
    ...(dice.in(0.08) && { clippingPlanes: [[...dice.vector(1), dice.between(0.3, 1)] as const] }),
    ...(dice.in(0.3) && { shadows: dice.of(['basic', 'vsm'] as const) }),
    ...(dice.in(0.05) && { sortObjects: false }),
    ...(own && dice.in(0.4) && { effects: [dice.of(effects)] }),
    ...(own && dice.in(0.15) && { shadowCascades: dice.whole(2, 4) }),
    ...(own && dice.in(0.2) && { lightLayers: true }),
  };
}

function chooseOutput(dice: Dice): ViewFacts {
  const depth = dice.in(0.25) ? { depth: dice.of(['logarithmic', 'reversed'] as const) } : {};
  const target = dice.of([undefined, undefined, undefined, 'half', 'bytes', 'canvas', 'canvas'] as const);
  if (target !== 'canvas') return { ...depth, ...(target && { target }) };
  const toneMapping = dice.of(['Linear', 'Reinhard', 'Cineon', 'ACESFilmic', 'AgX', 'Neutral'] as const);
  return {
    ...depth,
    target,
    ...(dice.in(0.6) && { toneMapping, exposure: dice.between(0.5, 2) }),
    ...(dice.in(0.2) && { linearOutput: true }),
  };
}

function dealDeck(number: number): Deck {
  const dice = new Dice(number * 7919 + 13);
  // what stock three has not is compared with another technique
  const own = dice.in(0.15) || number % 5 === 4;
  const templates = Array.from({ length: 6 }, () => chooseTemplate(dice));
  const color = 0x808080 | dice.color();
  const plain = {
    material: { type: 'MeshStandardMaterial', color, roughness: dice.between(0.3, 1) },
    receiveShadow: true,
  };
  const { as: _, traits: _traits, ...chosen } = chooseTemplate(dice);
  const isMesh = String(chosen.material?.type).startsWith('Mesh');
  return {
    world: chooseWorld(dice, own),
    view: chooseOutput(dice),
    floor: dice.in(0.4) && isMesh ? { ...chosen, receiveShadow: true } : plain,
    templates,
    plans: [planLights(dice, own), planLights(dice, own)],
  };
}

function chooseBackground(dice: Dice): WorldFacts {
  const intensity = dice.in(0.3) ? { backgroundIntensity: dice.between(0.3, 1.5) } : {};
  const background = dice.of([undefined, dice.color(), dice.color(), 'colour', 'cube', 'equirect'] as const);
  if (background === undefined)
    return dice.in(0.5) ? { clearColor: dice.color(), clearAlpha: dice.of([0, 0.5, 1]) } : {};
  if (typeof background === 'number' || background === 'colour') return { background, ...intensity };
  const turned = dice.in(0.5) ? { backgroundRotation: dice.vector(1) } : {};
  const blurred = background === 'equirect' && dice.in(0.4) ? { backgroundBlurriness: dice.between(0.1, 0.8) } : {};
  return { background, ...intensity, ...turned, ...blurred };
}

function chooseCamera(dice: Dice): ViewFacts {
  const camera = dice.of([...Array.from({ length: 9 }, () => undefined), 'orthographic', 'array', 'two'] as const);
  return {
    ...(camera && { camera }),
    position: [dice.between(-3, 3), dice.between(-0.5, 3.5), dice.between(4.5, 8)],
    lookAt: dice.vector(0.6),
    ...(dice.in(0.3) && { fov: dice.between(20, 90) }),
    ...(dice.in(0.2) && { near: dice.of([0.001, 0.01, 1, 3]) }),
    ...(dice.in(0.2) && { far: dice.of([12, 100, 1000, 1e5]) }),
    ...(dice.in(0.1) && { zoom: dice.between(0.6, 1.8) }),
    ...(dice.in(0.08) && { offset: [dice.whole(-30, 30), dice.whole(-20, 20)] as const }),
    ...(dice.in(0.08) && { parent: { position: dice.vector(0.3), rotation: dice.vector(0.1) } }),
    ...(dice.in(0.15) && { layers: [dice.of([1, 2])] }),
  };
}

/** Chooses the scene of a seed, a whole number from 0. The {@link DECK} scenes from a multiple of it on share their programs. */
export function chooseScene(seed: number): SceneFacts {
  const deck = dealDeck(Math.floor(seed / DECK));
  const dice = new Dice(seed);
  const things = Array.from({ length: dice.whole(2, 7) }, () => placeThing(dice, dice.of(deck.templates)));
  return {
    world: { ...deck.world, ...chooseBackground(dice) },
    view: { ...deck.view, ...chooseCamera(dice) },
    things: [...chooseRoom(dice, deck.floor), ...things],
    lights: placeLights(dice, dice.of(deck.plans)),
  };
}
