import { chooseMaterial } from './chooseMaterial';
import type { Dice } from './Dice';
import { type Kind, kinds, type Shape, type ThingFacts, type Three, type Trait } from './SceneFacts';

const shapes: readonly Shape[] = ['ball', 'box', 'knot', 'sheet', 'cone', 'bowl', 'crystal'];
const traits: readonly Trait[] = ['interleaved', 'without index', 'wide index', 'bytes', 'range', 'tangents'];

/** Chooses an object without a place: its kind, geometry and material, which decide upon its programs. */
export function chooseTemplate(dice: Dice): ThingFacts {
  const kind: Kind = dice.in(0.5) ? 'mesh' : dice.of(kinds);
  const material = chooseMaterial(dice, kind);
  const chosen = dice.in(0.3) ? [dice.of(traits)] : [];
  if (material.flatShading === true && dice.in(0.3)) chosen.push('without normals');
  return {
    ...(kind !== 'mesh' && { as: kind }),
    shape: dice.of(shapes),
    ...(chosen.length > 0 && { traits: chosen }),
    material,
    ...(dice.in(0.6) && { castShadow: true }),
    ...(dice.in(0.7) && { receiveShadow: true }),
    ...(dice.in(0.06) && { callback: dice.of(['clears', 'colours', 'listens']) }),
  };
}

function chooseScale(dice: Dice): Three {
  const size = dice.between(0.6, 1.5);
  if (dice.in(0.12)) return [-size, size, size];
  if (dice.in(0.12)) return [size, dice.between(0.3, 2), dice.between(-2, -0.3)];
  return [size, size, size];
}

/** Parents of an object, which undo its scale, or turn it. */
function chooseParents(dice: Dice): ThingFacts['parents'] {
  const far = dice.of([1e-3, 0.1, 50, 1000]);
  return dice.of([
    [{ position: dice.vector(0.3), rotation: dice.vector(0.5) }],
    [{ scale: [1, 0.6, 1.4], rotation: dice.vector(0.4) }, { rotation: dice.vector(0.4) }],
    [{ scale: [-1, 1, 1] }, { position: dice.vector(0.2) }],
    [{ scale: [far, far, far] }, { scale: [1 / far, 1 / far, 1 / far] }],
  ]);
}

/** Puts an object somewhere before the camera. */
export function placeThing(dice: Dice, template: ThingFacts): ThingFacts {
  return {
    ...template,
    position: [dice.between(-2.6, 2.6), dice.between(-0.9, 1.8), dice.between(-1.8, 2)],
    rotation: dice.vector(3),
    scale: chooseScale(dice),
    ...(dice.in(0.15) && { parents: chooseParents(dice) }),
    ...(dice.in(0.1) && { renderOrder: dice.of([-1, 1, 2]) }),
    ...(dice.in(0.06) && { layer: dice.of([1, 2]) }),
    ...(dice.in(0.1) && { frustumCulled: false }),
  };
}

/** A floor and a wall, for shadows and the edges of lights to fall on. */
export function chooseRoom(dice: Dice, floor: ThingFacts): ThingFacts[] {
  const wide = dice.of([12, 12, 12, 40, 100]);
  const shape = wide > 12 ? 'tiles' : 'sheet'; // see `leftOut`
  const room: ThingFacts[] = [
    { ...floor, shape, position: [0, -1.3, 0], rotation: [-1.5708, 0, 0], scale: [wide, wide, 1] },
  ];
  if (dice.in(0.6))
    room.push({ ...floor, shape: 'sheet', position: [0.1, 2, -2.9], rotation: [0.05, 0.1, 0], scale: [14, 9, 1] });
  return room;
}
