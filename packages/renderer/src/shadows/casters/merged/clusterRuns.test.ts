import { FrontSide } from 'three';
import { describe, expect, it } from 'vitest';
import { cubeFacesOf } from '../../slots/cubeFacesOf';
import { makeReach } from '../../slots/reach';
import { makeCubeFaces } from '../../slots/ShadowFace';
import { uniteBoxes } from '../uniteBoxes';
import { addCubeRuns } from './clusterRuns';
import { CLUSTER_TRIANGLES, CLUSTERS_PER_GROUP } from './ClusterOrder';

const INDICES = CLUSTER_TRIANGLES * 3;

function random(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

/** `count` boxes along a random path, the last with one triangle. */
function makeClusters(count: number, next: () => number) {
  const boxes = new Float64Array(count * 6);
  const place = [0, 1, 2].map(() => next() * 8 - 4);
  for (let i = 0; i < boxes.length; i++) {
    const axis = i % 6;
    boxes[i] = axis < 3 ? (place[axis] += next() - 0.5) : next() * 0.4;
  }
  const groups = new Float64Array(Math.ceil(count / CLUSTERS_PER_GROUP) * 6);
  for (let group = 0; group < groups.length; group += 6) {
    const end = Math.min(boxes.length, (group + 6) * CLUSTERS_PER_GROUP);
    uniteBoxes(boxes, group * CLUSTERS_PER_GROUP, end, groups, group);
  }
  return { boxes, groups, first: 3000, page: 0, geometry: { index: { length: (count - 1) * INDICES + 3 } } };
}

describe('addCubeRuns', () => {
  it('draws each cluster in all faces that draw and see it, once, and in no other', () => {
    const next = random(21);
    let seen = 0;
    let wrong = 0;
    for (let run = 0; run < 300; run++) {
      const faces = makeCubeFaces();
      const clusters = makeClusters(1 + Math.floor(next() * 40), next);
      const reach = makeReach(next() - 0.5, next() - 0.5, next() - 0.5, 1 + next() * 6, 1 + next() * 0.1);
      const drawnFaces = run % 3 === 0 ? 63 : Math.floor(next() * 64);
      addCubeRuns({ faces, reach, drawnFaces }, clusters, FrontSide);
      const { length } = clusters.geometry.index;
      faces.forEach((face, i) => {
        const drawn = new Uint8Array(length);
        const { count, starts, counts } = face.runs(0, FrontSide);
        for (let k = 0; k < count; k++) {
          const first = starts[k] / 4 - 3000;
          if (first < 0 || first + counts[k] > length) wrong++;
          for (let at = first; at < first + counts[k]; at++) drawn[at]++;
        }
        for (let at = 0; at < length; at++) {
          const cluster = Math.floor(at / INDICES);
          const sees = ((cubeFacesOf(clusters.boxes, cluster * 6, reach) & drawnFaces) >> i) & 1;
          if (drawn[at] !== sees) wrong++;
          seen += sees;
        }
      });
    }
    expect(wrong).toBe(0);
    expect(seen).toBeGreaterThan(100_000);
  });
});
