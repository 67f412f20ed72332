import { shortText } from '@farol/editing';
import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Object3D,
} from 'three';
import { Slices } from '../base/Slices';

/** Largest coordinate and scale (m): beyond it, floats are too coarse for cameras, lights and depths. */
export const LARGEST = 1e12;

/** Whether a matrix, or a point at distance `reach` (m) that it transforms, is beyond the range of `LARGEST`. */
export const absurdSize = ({ elements }: Matrix4, reach = 1): boolean =>
  !elements.every((each) => Math.abs(each) * reach <= LARGEST);

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Number of elements that are checked before the check may yield to the page. */
const STEP = 16_384;

/** Largest absolute coordinate of some points; NaN when one is not a number. */
async function reachOf(positions: Attribute, slices: Slices): Promise<number> {
  const components = Math.min(3, positions.itemSize);
  let reach = 0;
  for (let i = 0; i < positions.count; i++) {
    if (i % STEP === 0 && slices.areOver) await slices.next();
    for (let component = 0; component < components; component++) {
      const value = Math.abs(positions.getComponent(i, component));
      // the comparison is negated so that NaN is kept too
      if (!(value <= reach)) reach = value;
      if (Number.isNaN(reach)) return NaN;
    }
  }
  return reach;
}

/** Largest of some indices; -1 without any. */
async function largestOf(index: Attribute, slices: Slices): Promise<number> {
  let largest = -1;
  for (let i = 0; i < index.count; i++) {
    if (i % STEP === 0 && slices.areOver) await slices.next();
    largest = Math.max(largest, index.getX(i));
  }
  return largest;
}

/** @returns the largest coordinate @throws Error when an index is out of range, or a position is not a number */
async function checkGeometry(geometry: BufferGeometry, name: string, slices: Slices): Promise<number> {
  const positions = geometry.getAttribute('position');
  if (geometry.index) {
    const largest = await largestOf(geometry.index, slices);
    if (largest >= positions.count) {
      const counts = `the index ${largest}, and ${positions.count} vertices, counted from 0`;
      throw new Error(`${name} has ${counts}: export it again.`);
    }
  }
  const reach = await reachOf(positions, slices);
  if (Number.isNaN(reach)) throw new Error(`${name} has positions that are not numbers: export it again.`);
  return reach;
}

/**
 * Checks a loaded model before it is first drawn, in slices, so that the page stays responsive.
 * @param signal - cancels the check
 * @throws Error (as a rejection) of one sentence when a position is not a number or beyond 1e12, or an index is out of
 *   range; the signal's abort reason
 */
export async function checkModel(scene: Object3D, signal?: AbortSignal): Promise<void> {
  const slices = new Slices(signal);
  const meshes: { readonly object: Object3D; readonly geometry: BufferGeometry }[] = [];
  scene.updateMatrixWorld(true);
  scene.traverse((object) => {
    const { geometry } = object as { geometry?: BufferGeometry };
    if (geometry?.getAttribute('position')) meshes.push({ object, geometry });
  });
  const reaches = new Map<BufferGeometry, number>();
  for (const { object, geometry } of meshes) {
    const name = object.name ? `the mesh '${shortText(object.name)}'` : 'a mesh';
    const reach = reaches.get(geometry) ?? (await checkGeometry(geometry, name, slices));
    reaches.set(geometry, reach);
    if (reach > LARGEST || absurdSize(object.matrixWorld, Math.max(1, reach))) {
      throw new Error(
        `${name} reaches beyond ${LARGEST} m, which cannot be drawn: scale it down, and export it again.`,
      );
    }
  }
}
