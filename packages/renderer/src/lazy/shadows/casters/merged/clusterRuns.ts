import type { Side } from 'three';
import { boxOutsidePlanes } from '../casterBox';
import { cubeFacesOf } from '../../slots/cubeFacesOf';
import { isBeyond, isWithin } from '../../slots/reach';
import type { ShadowFace } from '../../slots/ShadowFace';
import type { ShadowSlot } from '../../slots/ShadowSlot';
import { CLUSTER_TRIANGLES, CLUSTERS_PER_GROUP } from './ClusterOrder';
import type { MergedCaster } from './MergedCaster';
import type { TriangleRuns } from './TriangleRuns';

const INDICES = CLUSTER_TRIANGLES * 3;
const GROUP_INDICES = CLUSTERS_PER_GROUP * INDICES;

/** Four bits, each in a byte of its own. */
const SPREAD = Int32Array.from({ length: 16 }, (_, i) => (i & 1) | ((i & 2) << 7) | ((i & 4) << 14) | ((i & 8) << 21));

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
    const near = cubeFacesOf(groups, group, reach);
    if ((near & drawnFaces) === 0) continue;
    const end = Math.min(length, start + GROUP_INDICES);
    const isOne = (near & (near - 1)) === 0;
    if (isOne && isWithin(reach, groups, group)) {
      runs[31 - Math.clz32(near)].add(first + start, end - start);
      continue;
    }
    let few = 0;
    let rest = 0;
    const endOfBoxes = Math.min(boxes.length, (group + 6) * CLUSTERS_PER_GROUP);
    for (let at = group * CLUSTERS_PER_GROUP, cluster = 0; at < endOfBoxes; at += 6, cluster++) {
      const seen = cubeFacesOf(boxes, at, reach);
      few |= SPREAD[seen & 15] << cluster;
      rest |= SPREAD[seen >> 4] << cluster;
    }
    for (let faces = near & drawnFaces; faces !== 0; faces &= faces - 1) {
      const face = 31 - Math.clz32(faces & -faces);
      const clusters = ((face < 4 ? few : rest) >>> ((face & 3) * 8)) & 255;
      if (clusters !== 0) addClusters(runs[face], clusters, first + start, first + end);
    }
  }
}

/**
 * Adds those clusters of a group that are set in eight bits.
 * @param start index of the group's first cluster, and after its last
 */
function addClusters(runs: TriangleRuns, clusters: number, start: number, end: number): void {
  let from = 0;
  while (clusters !== 0) {
    const skipped = trailingZeros(clusters);
    clusters >>>= skipped;
    const count = trailingZeros(~clusters);
    clusters >>>= count;
    from += skipped;
    const index = start + from * INDICES;
    runs.add(index, Math.min(end - index, count * INDICES));
    from += count;
  }
}

function trailingZeros(bits: number): number {
  return 31 - Math.clz32(bits & -bits);
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
