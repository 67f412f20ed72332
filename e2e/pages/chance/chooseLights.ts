import type { Dice } from './Dice';
import type { LightFacts, ShadowFacts } from './SceneFacts';

type Kind = NonNullable<LightFacts['kind']>;

/** Light without its place: what programs of stock three depend on. */
export type LightPlan = Pick<LightFacts, 'kind' | 'map' | 'count' | 'profile' | 'cookie' | 'shape' | 'castShadow'> & {
  readonly shadowed?: boolean;
};

const casting: readonly Kind[] = ['directional', 'point', 'spot'];

/** Chooses which lights there are, by kind and number. */
export function planLights(dice: Dice, own: boolean): LightPlan[] {
  const plan: LightPlan[] = [];
  if (dice.in(0.7)) plan.push({ kind: dice.of(['ambient', 'hemisphere', 'hemisphere']) });
  if (dice.in(0.12)) plan.push({ kind: 'probe' });
  for (let left = dice.of([1, 1, 2, 3, 4]); left > 0; left--) {
    const kind = dice.of(['directional', 'point', 'point', 'point', 'spot', 'spot', 'spot', 'area'] as const);
    plan.push({
      kind,
      ...(casting.includes(kind) && dice.in(0.45) && { shadowed: true }),
      ...(kind === 'spot' && dice.in(0.3) && { map: dice.of(['colour', 'grey', 'checker']) }),
      ...(own && kind === 'area' && dice.in(0.5) && { shape: dice.of(['disc', 'tube'] as const) }),
      ...(own && kind === 'area' && dice.in(0.4) && { castShadow: true }),
      ...(own && (kind === 'spot' || kind === 'point') && dice.in(0.3) && { profile: true }),
      ...(own && kind === 'point' && dice.in(0.3) && { cookie: true }),
    });
  }
  // seldom, since stock three unrolls its shaders' loops over lights: many lights compile slowly
  if (dice.in(0.25)) plan.push({ kind: dice.of(['point', 'spot'] as const), count: dice.of([6, 12, 20]) });
  if (dice.in(0.1)) plan.push({ kind: 'field', count: dice.of([3, 12]) });
  return plan;
}

function chooseShadow(dice: Dice): ShadowFacts {
  return {
    ...(dice.in(0.7) && { mapSize: dice.of([64, 128, 256, 1024]) }),
    bias: -dice.of([0.002, 0.005, 0.01]),
    ...(dice.in(0.3) && { normalBias: dice.between(0, 0.05) }),
    ...(dice.in(0.3) && { radius: dice.between(0, 5) }),
    ...(dice.in(0.2) && { blurSamples: dice.whole(2, 12) }),
    ...(dice.in(0.2) && { intensity: dice.between(0.2, 1) }),
    ...(dice.in(0.2) && { near: dice.between(0.1, 1), far: dice.between(8, 40) }),
  };
}

/** Gives each light of a plan its place, colour and reach. */
export function placeLights(dice: Dice, plan: readonly LightPlan[]): LightFacts[] {
  return plan.map(({ shadowed, ...facts }) => {
    const { kind = 'point' } = facts;
    const many = facts.count === undefined ? 1 : 0.3;
    const light = {
      ...facts,
      color: dice.color() | 0x404040,
      ...(dice.in(0.04) && { layer: dice.of([1, 2]) }),
      ...(shadowed && { shadow: chooseShadow(dice) }),
    };
    if (kind === 'ambient') return { ...light, intensity: dice.between(0.1, 0.8) };
    if (kind === 'probe') return { ...light, intensity: dice.between(0.2, 1) };
    const position = [dice.between(-3, 3), dice.between(0.5, 4), dice.between(-2, 4)] as const;
    if (kind === 'hemisphere') return { ...light, position, ground: dice.color(), intensity: dice.between(0.1, 0.8) };
    const target = dice.vector(1);
    if (kind === 'directional') return { ...light, position, target, intensity: dice.between(0.2, 2) };
    if (kind === 'area') {
      const [width, height] = [dice.between(0.1, 2), facts.shape === 'tube' ? 0.06 : dice.between(0.1, 3)];
      return { ...light, position, target, width, height, intensity: dice.between(1, 8) };
    }
    const reach = dice.in(0.75) ? { distance: dice.between(2, 12) } : {};
    const decay = dice.in(0.2) ? { decay: dice.between(0.5, 2.5) } : {};
    const intensity = Number((dice.between(3, 18) * many).toPrecision(2));
    const cone = { angle: dice.between(0.2, 1.3), penumbra: dice.between(0.1, 1) };
    if (kind === 'field')
      return {
        ...light,
        position,
        target,
        distance: dice.between(2, 6),
        ...decay,
        ...(dice.in(0.5) && cone),
        intensity,
      };
    if (kind === 'point') return { ...light, position, ...reach, ...decay, intensity };
    return { ...light, position, target, ...reach, ...decay, ...cone, intensity: intensity * 2 };
  });
}
