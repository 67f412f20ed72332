import { describe, expect, it } from 'vitest';
import { coneBoundingSphere } from './spheres';
import { coneIntersectsSphere, coneSupport } from './cones';
import { projectedConeBounds, projectedSphereBounds } from './projection';
import { createRandom, project, randomDirection, testCameras } from './testing/testScenes';

type Vector = [number, number, number];
interface Cone {
  apex: Vector;
  axis: Vector;
  range: number;
  angle: number;
}

const bounds = new Float64Array(4);
const sphere = new Float64Array(4);

function randomCone(random: () => number, reach: number): Cone {
  const depth = (random() * 1.2 - 0.2) * reach;
  const apex: Vector = [(random() * 2 - 1) * (Math.abs(depth) + 1), (random() * 2 - 1) * (Math.abs(depth) + 1), -depth];
  return { apex, axis: randomDirection(random), range: reach * 0.3 * random(), angle: 0.01 + 1.56 * random() };
}

/** A point of the cone; `angle` and `length` are shares of the cone's. */
function pointOf({ apex, axis, range, angle }: Cone, share: number, turn: number, length: number): Vector {
  const helper: Vector = Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const side = normalized(cross(axis, helper));
  const up = cross(axis, side);
  const along = Math.cos(share * angle) * length * range;
  const across = Math.sin(share * angle) * length * range;
  return [0, 1, 2].map(
    (i) => apex[i] + axis[i] * along + across * (side[i] * Math.cos(turn) + up[i] * Math.sin(turn)),
  ) as Vector;
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function normalized(a: Vector): Vector {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
}

function randomPoint(cone: Cone, random: () => number): Vector {
  const edge = random();
  return pointOf(cone, edge < 0.5 ? 1 : random(), random() * 2 * Math.PI, edge > 0.3 ? 1 : random());
}

describe.each(testCameras)('the rectangle of a cone, $name', ({ projection, near, far }) => {
  const reach = Math.min(far, 60);

  it('holds every point of it that is between near and far', () => {
    const random = createRandom(21);
    let points = 0;
    for (let i = 0; i < 200; i++) {
      const cone = randomCone(random, reach);
      const visible = projectedConeBounds(...cone.apex, ...cone.axis, cone.range, cone.angle, projection, bounds);
      for (let k = 0; k < 200; k++) {
        const [x, y, z] = randomPoint(cone, random);
        if (-z < near || -z > far) continue;
        const [u, v] = project(projection, x, y, z);
        points++;
        const outside = visible
          ? u < bounds[0] - 1e-9 || v < bounds[1] - 1e-9 || u > bounds[2] + 1e-9 || v > bounds[3] + 1e-9
          : Math.abs(u) <= 1 && Math.abs(v) <= 1;
        if (outside) expect([u, v], JSON.stringify(cone)).toEqual([...bounds]);
      }
    }
    expect(points).toBeGreaterThan(2500);
  });

  it('is no larger than it, to within 3%, where it is wholly between near and far', () => {
    const random = createRandom(22);
    let compared = 0;
    for (let i = 0; i < 250; i++) {
      const cone = randomCone(random, reach);
      const nearest = -cone.apex[2] - coneSupport(cone.axis[2], cone.range, cone.angle);
      const farthest = -cone.apex[2] + coneSupport(-cone.axis[2], cone.range, cone.angle);
      // samples cannot measure the size of a cone that nearly touches the eye
      if (nearest < Math.max(near, 0.05 * cone.range) || farthest > far) continue;
      if (!projectedConeBounds(...cone.apex, ...cone.axis, cone.range, cone.angle, projection, bounds)) continue;
      const sampled = [Infinity, Infinity, -Infinity, -Infinity];
      const take = (point: Vector) => {
        const [u, v] = project(projection, ...point);
        sampled[0] = Math.min(sampled[0], u);
        sampled[1] = Math.min(sampled[1], v);
        sampled[2] = Math.max(sampled[2], u);
        sampled[3] = Math.max(sampled[3], v);
      };
      take(cone.apex);
      for (let turn = 0; turn < 90; turn++) {
        for (let share = 0; share <= 20; share++) take(pointOf(cone, share / 20, (turn / 90) * 2 * Math.PI, 1));
      }
      compared++;
      for (let side = 0; side < 4; side++) {
        const size = sampled[(side % 2) + 2] - sampled[side % 2];
        if (!(Math.abs(bounds[side] - sampled[side]) <= 0.03 * size)) {
          expect([...bounds], `side ${side} of ${JSON.stringify(cone)}`).toEqual(sampled);
        }
      }
    }
    expect(compared).toBeGreaterThan(10);
  });

  it('is within the rectangle of its bounding sphere', () => {
    const random = createRandom(23);
    const other = new Float64Array(4);
    for (let i = 0; i < 300; i++) {
      const cone = randomCone(random, reach);
      if (!projectedConeBounds(...cone.apex, ...cone.axis, cone.range, cone.angle, projection, bounds)) continue;
      coneBoundingSphere(...cone.apex, ...cone.axis, cone.range, cone.angle, sphere);
      expect(projectedSphereBounds(sphere, 0, projection, other)).toBe(true);
      for (const side of [0, 1]) expect(bounds[side]).toBeGreaterThanOrEqual(other[side]);
      for (const side of [2, 3]) expect(bounds[side]).toBeLessThanOrEqual(other[side]);
    }
  });
});

describe('coneBoundingSphere', () => {
  it('holds the cone, and none smaller does', () => {
    const random = createRandom(31);
    for (let i = 0; i < 300; i++) {
      const cone = randomCone(random, 20);
      const [x, y, z, r] = coneBoundingSphere(...cone.apex, ...cone.axis, cone.range, cone.angle, sphere);
      const distance = (p: Vector) => Math.hypot(p[0] - x, p[1] - y, p[2] - z);
      const farthest = Math.max(...Array.from({ length: 50 }, () => distance(randomPoint(cone, random))));
      expect(farthest).toBeLessThanOrEqual(r * (1 + 1e-9));
      // points of the cone on the sphere, on opposite sides: the rim, or the rim and the apex
      expect(distance(pointOf(cone, 1, 0, 1))).toBeCloseTo(r, 9);
      expect(distance(pointOf(cone, 1, Math.PI, 1))).toBeCloseTo(r, 9);
      if (cone.angle < Math.PI / 4) expect(distance(cone.apex)).toBeCloseTo(r, 9);
      else expect(r).toBeCloseTo(cone.range * Math.sin(cone.angle), 9);
    }
  });
});

describe('coneIntersectsSphere', () => {
  it('is true exactly when a point of the cone is in the sphere', () => {
    const random = createRandom(41);
    const found = { touching: 0, apart: 0 };
    for (let i = 0; i < 300; i++) {
      const cone = randomCone(random, 10);
      const centre = randomDirection(random).map((c, k) => cone.apex[k] + c * cone.range * 1.6 * random()) as Vector;
      // the least distance over the section of the cone through the centre, by a grid
      const offset = centre.map((c, k) => c - cone.apex[k]) as Vector;
      const along = offset[0] * cone.axis[0] + offset[1] * cone.axis[1] + offset[2] * cone.axis[2];
      const across = Math.sqrt(Math.max(0, Math.hypot(...offset) ** 2 - along * along));
      let distance = Infinity;
      for (let a = 0; a <= 50; a++) {
        for (let l = 0; l <= 50; l++) {
          const angle = (a / 50) * cone.angle;
          const length = (l / 50) * cone.range;
          const before = along - length * Math.cos(angle);
          const beside = across - length * Math.sin(angle);
          distance = Math.min(distance, Math.sqrt(before * before + beside * beside));
        }
      }
      const slack = 0.04 * cone.range;
      const touches = (radius: number) =>
        coneIntersectsSphere(
          [0, ...cone.apex, cone.range],
          [0, ...cone.axis.map((c) => -c), Math.cos(cone.angle)],
          1,
          [0, 0, ...centre, radius],
          2,
        );
      expect(touches(distance + 1e-9), JSON.stringify({ cone, centre, distance })).toBe(true);
      found.touching++;
      if (distance > slack) {
        expect(touches(distance - slack), JSON.stringify({ cone, centre, distance })).toBe(false);
        found.apart++;
      }
    }
    expect(found.apart).toBeGreaterThan(50);
  });
});
