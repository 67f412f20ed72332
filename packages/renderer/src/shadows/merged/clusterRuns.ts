import type { Side } from 'three';
import { boxOutsidePlanes } from '../casterBox';
import { cubeFacesOf } from '../cubeFacesOf';
import { isBeyond, isWithin } from '../reach';
import type { ShadowFace } from '../ShadowFace';
import type { ShadowSlot } from '../ShadowSlot';
import { CLUSTER_TRIANGLES, CLUSTERS_PER_GROUP } from './ClusterOrder';
import type { MergedCaster } from './MergedCaster';
import type { TriangleRuns } from './TriangleRuns';

const INDICES = CLUSTER_TRIANGLES * 3;
const GROUP_INDICES = CLUSTERS_PER_GROUP * INDICES;

/** Of the six faces of a cube. */
const runs: TriangleRuns[] = [];

type Faces = Pick<ShadowSlot, 'faces' | 'reach' | 'drawnFaces'>;
type Clusters = Pick<MergedCaster, 'boxes' | 'groups' | 'first' | 'page'> & {
  readonly geometry: { readonly index: ArrayLike<number> };
};

/**
 * Has each face of a cube map draw the clusters of a caster that it sees.
 * @param side of the triangles that is seen
 */
export function addCubeRuns({ faces, reach, drawnFaces }: Faces, merged: Clusters, side: Side): void {
  const { boxes, groups, first, page } = merged;
  for (let i = 0; i < 6; i++) runs[i] = faces[i].runs(page, side);
  const { length } = merged.geometry.index;
  for (let group = 0, start = 0; start < length; group += 6, start += GROUP_INDICES) {
    const near = drawnFaces & cubeFacesOf(groups, group, reach);
    if (near === 0) continue;
    const end = Math.min(length, start + GROUP_INDICES);
    const isOne = (near & (near - 1)) === 0;
    if (isOne && isWithin(reach, groups, group)) {
      runs[31 - Math.clz32(near)].add(first + start, end - start);
      continue;
    }
    for (let from = start, at = group * CLUSTERS_PER_GROUP; from < end; from += INDICES, at += 6) {
      const count = Math.min(INDICES, end - from);
      let seen = near & cubeFacesOf(boxes, at, reach);
      while (seen !== 0) {
        const face = 31 - Math.clz32(seen);
        seen ^= 1 << face;
        runs[face].add(first + from, count);
      }
    }
  }
}

/** The same for the faces of other maps, each in the part of it that is drawn. */
export function addMapRuns({ faces, reach }: Faces, merged: Clusters, side: Side): void {
  const { boxes, groups, first, page } = merged;
  const { length } = merged.geometry.index;
  for (let group = 0, start = 0; start < length; group += 6, start += GROUP_INDICES) {
    if (isBeyond(reach, groups, group) || !isSeenByAny(faces, groups, group)) continue;
    const end = Math.min(length, start + GROUP_INDICES);
    for (let from = start, at = group * CLUSTERS_PER_GROUP; from < end; from += INDICES, at += 6) {
      if (isBeyond(reach, boxes, at)) continue;
      for (const face of faces) {
        if (boxOutsidePlanes(face.drawnPlanes, boxes, at)) continue;
        face.runs(page, side).add(first + from, Math.min(INDICES, end - from));
      }
    }
  }
}

/** True when one of the faces may see some of a box, from index `at` on, in the part of it that is drawn. */
function isSeenByAny(faces: readonly ShadowFace[], boxes: Float64Array, at: number): boolean {
  for (const face of faces) if (!boxOutsidePlanes(face.drawnPlanes, boxes, at)) return true;
  return false;
}
