import type { FieldEdit } from '@farol/editing';
import { createRandom, type GameObject, Light, ObjectRenderer } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Color } from 'three';
import type { Arrangement } from './Arrangement';

/** Multiplier of the copy's index in seeds, so that neighbouring copies get unrelated random numbers. */
const STRIDE = 2654435761;

/** Random generator of the `index`th copy: independent of the number of copies. */
export const randomOf = (seed: number, index: number): (() => number) =>
  createRandom(Math.imul(seed, STRIDE) + Math.imul(index + 1, 7919));

/** A saturated linear colour of a hue (0 to 1), as bright as another colour. */
function colourOf(hue: number, like: Vector3Tuple): Vector3Tuple {
  const colour = new Color().setHSL(hue, 1, 0.6);
  const brightest = Math.max(colour.r, colour.g, colour.b);
  const factor = Math.max(...like) / brightest || 1 / brightest;
  const digits = (value: number): number => Number((value * factor).toFixed(4));
  return [digits(colour.r), digits(colour.g), digits(colour.b)];
}

/**
 * Edits that vary the lights of one copy: colour, intensity and range of each Light, and the colour of bulbs, which are
 * unlit meshes beside a light.
 * @param object - the copy, or an original; it is only read
 * @param index - index of the copy @param total - number of copies
 */
export function lightEdits(object: GameObject, arrangement: Arrangement, index: number, total: number): FieldEdit[] {
  const { colours, intensityVariation, rangeVariation, seed } = arrangement;
  const share = arrangement.sharesLight ? total : 1;
  if (colours === 'same' && intensityVariation === 0 && rangeVariation === 0 && share === 1) return [];
  const random = randomOf(seed, index);
  const [anyHue, byIntensity, byRange] = [random(), random(), random()];
  const hue = colours === 'random' ? anyHue : index / total;
  const factor = (variation: number, r: number): number => 1 + variation * (2 * r - 1);
  const vary = (value: number, by: number, r: number): number => Number((value * factor(by, r)).toPrecision(5));
  const edits: FieldEdit[] = [];
  object.traverse((each) => {
    const owner = each.getComponent(Light);
    if (!owner) return;
    const bulb = each.getComponent(ObjectRenderer);
    if (colours !== 'same') {
      const value = colourOf(hue, owner.colour);
      edits.push({ owner, name: 'colourBy', value: 'hand' }, { owner, name: 'diffuse', value });
      if (bulb?.kind === 'basic') edits.push({ owner: bulb, name: 'colour', value });
    }
    if (intensityVariation > 0 || share > 1)
      edits.push({ owner, name: 'intensity', value: vary(owner.intensity / share, intensityVariation, byIntensity) });
    if (rangeVariation > 0) edits.push({ owner, name: 'range', value: vary(owner.range, rangeVariation, byRange) });
  });
  return edits;
}
