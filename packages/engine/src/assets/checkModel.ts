import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Object3D,
} from 'three';
import { shortText } from '@farol/renderer';

/** Largest coordinate and scale (m): beyond it cameras, lights and depths have no digits left. */
export const LARGEST = 1e12;

/** Whether a matrix, or what it does to a reach, is beyond what can be drawn. */
export const absurdSize = ({ elements }: Matrix4, reach = 1): boolean =>
  !elements.every((each) => Math.abs(each) * reach <= LARGEST);

/** Largest coordinate of some points; NaN when one is no number. */
function reachOf(positions: BufferAttribute | InterleavedBufferAttribute): number {
  let reach = 0;
  for (let i = 0; i < positions.count; i++) {
    for (let component = 0; component < Math.min(3, positions.itemSize); component++) {
      const value = Math.abs(positions.getComponent(i, component));
      // a comparison with NaN is false
      if (!(value <= reach)) reach = value;
      if (Number.isNaN(reach)) return NaN;
    }
  }
  return reach;
}

/**
 * Checks what a loader made of a model before a frame is drawn with it.
 * @throws Error of one sentence when positions are no numbers, or lie beyond 1e12
 */
export function checkModel(scene: Object3D): void {
  const reaches = new Map<BufferGeometry, number>();
  scene.updateMatrixWorld(true);
  scene.traverse((object) => {
    const { geometry } = object as { geometry?: BufferGeometry };
    const positions = geometry?.getAttribute('position');
    if (!geometry || !positions) return;
    let reach = reaches.get(geometry);
    if (reach === undefined) reaches.set(geometry, (reach = reachOf(positions)));
    const name = object.name ? `the mesh '${shortText(object.name)}'` : 'a mesh';
    if (Number.isNaN(reach)) throw new Error(`${name} has positions that are no numbers: export it again.`);
    if (reach > LARGEST || absurdSize(object.matrixWorld, Math.max(1, reach))) {
      throw new Error(
        `${name} reaches beyond ${LARGEST} m, which cannot be drawn: scale it down, and export it again.`,
      );
    }
  });
}
