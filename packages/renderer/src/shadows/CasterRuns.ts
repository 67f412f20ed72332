import type { Mesh } from 'three';
import { boxOutsidePlanes, squaredDistanceToBox } from './casterBox';
import { moveBox } from './moveBox';
import type { Caster } from './ShadowCasters';
import type { ShadowFace } from './ShadowFace';
import type { ShadowSlot } from './ShadowSlot';
import { CLUSTER_VERTICES, triangleClusters } from './triangleClusters';

/** So many clusters between two that are drawn are drawn as well: another draw would cost as much; see PERFORMANCE.md. */
const GAP = 16;

/** The parts of a caster's triangles that the faces of a shadow map see: runs of its clusters, see `triangleClusters`. */
export class CasterRuns {
  private reached = new Uint8Array(256);
  private boxes: Float64Array | null = null;
  private count = 0;

  /**
   * Takes up a caster that a light reaches.
   * @returns false where it is drawn whole
   */
  begin(caster: Caster, slot: ShadowSlot): boolean {
    const mesh = caster.object as Mesh;
    if (!caster.hasBox || !mesh.isMesh || Array.isArray(mesh.material)) return false;
    const own = triangleClusters(mesh.geometry);
    if (own === null) return false;
    if (caster.clusters?.length !== own.length) {
      caster.clusters = new Float64Array(own.length);
      caster.clustersPlaced = false;
    }
    const boxes = (this.boxes = caster.clusters!);
    if (!caster.clustersPlaced) {
      for (let i = 0; i < own.length; i += 6) moveBox(own, i, mesh.matrixWorld, boxes, i);
      caster.clustersPlaced = true;
    }
    const count = (this.count = own.length / 6);
    if (this.reached.length < count) this.reached = new Uint8Array(2 * count);
    const squaredRange = slot.range * slot.range;
    const e = slot.faces[0].camera.matrixWorld.elements;
    for (let i = 0; i < count; i++) {
      this.reached[i] = squaredDistanceToBox(boxes, e[12], e[13], e[14], i * 6) <= squaredRange ? 1 : 0;
    }
    return true;
  }

  /** Adds what a face sees of the caster to what the face draws. @returns whether that is anything */
  addTo(face: ShadowFace, caster: Caster): boolean {
    const { boxes, count, reached } = this;
    let first = -1;
    let last = -1;
    for (let i = 0; i < count; i++) {
      if (reached[i] === 0 || boxOutsidePlanes(face.planes, boxes!, i * 6)) continue;
      if (first >= 0 && i - last > GAP + 1) {
        face.add(caster, first * CLUSTER_VERTICES, (last + 1 - first) * CLUSTER_VERTICES);
        first = i;
      } else if (first < 0) first = i;
      last = i;
    }
    if (first < 0) return false;
    face.add(caster, first * CLUSTER_VERTICES, (last + 1 - first) * CLUSTER_VERTICES);
    return true;
  }
}
