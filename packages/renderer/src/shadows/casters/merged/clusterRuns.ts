import type { Side } from 'three';
import type { MergedCaster } from '../Caster';
import { boxOutsidePlanes } from '../casterBox';
import { cubeFacesOf } from '../../slots/cubeFacesOf';
import { isBeyond, isWithin } from '../../slots/reach';
import type { ShadowFace } from '../../slots/ShadowFace';
import type { ShadowSlot } from '../../slots/ShadowSlot';
import { CLUSTER_TRIANGLES, CLUSTERS_PER_GROUP } from './ClusterOrder';

import type { TriangleRuns } from './TriangleRuns';

const INDICES = CLUSTER_TRIANGLES * 3;
const GROUP_INDICES = CLUSTERS_PER_GROUP * INDICES;

/** For each number from 0 to 15, its four bits spread to four bytes. */
const SPREAD = Int32Array.from({ length: 16 }, (_, i) => (i & 1) | ((i & 2) << 7) | ((i & 4) << 14) | ((i & 8) << 21));

/** Reused list: index ranges to draw, one set for each of the six faces of a cube map. */
const runs: TriangleRuns[] = [];

type Faces = Pick<ShadowSlot, 'faces' | 'reach' | 'drawnFaces'>;
type Clusters = Pick<MergedCaster, 'boxes' | 'groups' | 'first' | 'page'> & {
  readonly geometry: { readonly index: ArrayLike<number> };
};

/**
 * Adds to the runs of each face of a cube map the clusters of a caster that the face may show.
 * @param side - side of the triangles that is drawn
 */
export function addCubeRuns({ faces, reach, drawnFaces }: Faces, merged: Clusters, side: Side): void {
  const { boxes, groups, first, page } = merged;
  for (let i = 0; i < 6; i++) runs[i] = faces[i].runs(page, side);
  const { length } = merged.geometry.index;
  for (let group = 0, start = 0; start < length; group += 6, start += GROUP_INDICES) {
    const shown = cubeFacesOf(groups, group, reach);
    if ((shown & drawnFaces) === 0) continue;
    const end = Math.min(length, start + GROUP_INDICES);
    const isOne = (shown & (shown - 1)) === 0;
    if (isOne && isWithin(reach, groups, group)) {
      runs[31 - Math.clz32(shown)].add(first + start, end - start);
      continue;
    }
    // one byte for each face, one bit for each cluster: faces 0 to 3 here, faces 4 and 5 in the next number
    let firstFaces = 0;
    let lastFaces = 0;
    const endOfBoxes = Math.min(boxes.length, (group + 6) * CLUSTERS_PER_GROUP);
    for (let at = group * CLUSTERS_PER_GROUP, cluster = 0; at < endOfBoxes; at += 6, cluster++) {
      const facesOfCluster = cubeFacesOf(boxes, at, reach);
      firstFaces |= SPREAD[facesOfCluster & 15] << cluster;
      lastFaces |= SPREAD[facesOfCluster >> 4] << cluster;
    }
    for (let faces = shown & drawnFaces; faces !== 0; faces &= faces - 1) {
      const face = 31 - Math.clz32(faces & -faces);
      const clusters = ((face < 4 ? firstFaces : lastFaces) >>> ((face & 3) * 8)) & 255;
      if (clusters !== 0) addClusters(runs[face], clusters, first + start, first + end);
    }
  }
}

/**
 * Adds those clusters of a group whose bits are set in `clusters`.
 * @param start - first index of the group's first cluster
 * @param end - index after the group's last cluster
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

/** Adds to the runs of each face the clusters of a caster that the face's drawn part may show, for maps other than cubes. */
export function addMapRuns({ faces, reach }: Faces, merged: Clusters, side: Side): void {
  const { boxes, groups, first, page } = merged;
  const { length } = merged.geometry.index;
  for (let group = 0, start = 0; start < length; group += 6, start += GROUP_INDICES) {
    if (isBeyond(reach, groups, group) || !isInAnyFace(faces, groups, group)) continue;
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

/** True when the drawn part of one of the faces may show some of a box, which starts at index `at`. */
function isInAnyFace(faces: readonly ShadowFace[], boxes: Float64Array, at: number): boolean {
  for (const face of faces) if (!boxOutsidePlanes(face.drawnPlanes, boxes, at)) return true;
  return false;
}
