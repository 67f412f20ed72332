import { GameObject, ObjectRenderer, Scene } from '@farol/engine';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { arrangement } from '../../model/testing/randomArrangement';
import { scatteredPlaces } from './scatteredPlaces';
import { SurfaceBelow } from './SurfaceBelow';
import { SurfaceSampler } from './SurfaceSampler';

type Triple = [number, number, number];

function mesh(scene: Scene, shape: string, position: Triple, scale: Triple, values = {}): GameObject {
  const object = new GameObject(shape);
  object.addComponent(ObjectRenderer, { mesh: shape, ...values });
  object.transform.position = position;
  object.transform.scale = scale;
  scene.add(object);
  scene.three.updateMatrixWorld();
  return object;
}

const scattered = (target: GameObject, settings: Parameters<typeof arrangement>[0], upwards = true): Vector3[] =>
  scatteredPlaces(arrangement({ kind: 'scatter', ...settings }), new SurfaceSampler([target], upwards), [0]).map(
    ({ position }) => new Vector3(...position),
  );

describe('SurfaceSampler', () => {
  it('knows the area of what is drawn, instances too', () => {
    const scene = new Scene();
    const box = mesh(scene, 'box', [0, 0, 0], [2, 3, 4], { instanced: true });
    expect(new SurfaceSampler([box], false).area).toBeCloseTo(2 * (6 + 8 + 12), 4);
    expect(new SurfaceSampler([box], true).area).toBeCloseTo(8, 4);
    expect(new SurfaceSampler([new GameObject('Empty')], true).area).toBe(0);
    scene.dispose();
  });
});

describe('scatteredPlaces', () => {
  it('puts as many on each part as it is large', () => {
    const scene = new Scene();
    const ground = mesh(scene, 'plane', [0, 1, 0], [30, 1, 10]);
    const small = mesh(scene, 'plane', [0, 5, 0], [10, 1, 10]);
    ground.add(small);
    small.transform.position = [0, 4, 0];
    small.transform.scale = [1 / 3, 1, 1];
    scene.three.updateMatrixWorld();
    const points = scattered(ground, { count: 4000, height: 0.5 });
    expect(points.length).toBe(4000);
    const below = points.filter(({ y }) => y < 3);
    // three quarters of the area; 60 is more than twice the standard deviation of 4,000 samples
    expect(Math.abs(below.length - 3000)).toBeLessThan(60);
    for (const { x, y, z } of below) {
      expect(y).toBeCloseTo(1.5, 5);
      expect(Math.abs(x)).toBeLessThanOrEqual(15.001);
      expect(Math.abs(z)).toBeLessThanOrEqual(5.001);
    }
    // the left half has as many as the right one
    expect(Math.abs(below.filter(({ x }) => x < 0).length - below.length / 2)).toBeLessThan(110);
    scene.dispose();
  });

  it('is the same for a seed, goes on for a larger count, and differs for another seed', () => {
    const scene = new Scene();
    const ground = mesh(scene, 'plane', [0, 0, 0], [10, 1, 10]);
    const few = scattered(ground, { count: 50 });
    expect(scattered(ground, { count: 200 }).slice(0, 50)).toEqual(few);
    expect(scattered(ground, { count: 50, seed: 2 })[0]).not.toEqual(few[0]);
    scene.dispose();
  });

  it('keeps them apart, and says by their number when no more fit', () => {
    const scene = new Scene();
    const ball = mesh(scene, 'sphere', [0, 0, 0], [4, 4, 4]);
    const points = scattered(ball, { count: 5000, minimumDistance: 0.5 }, false);
    expect(points.length).toBeGreaterThan(100);
    expect(points.length).toBeLessThan(400);
    points.forEach((point, i) => {
      for (const other of points.slice(0, i)) expect(point.distanceTo(other)).toBeGreaterThanOrEqual(0.5);
    });
    scene.dispose();
  });

  it('stands them on the surface with their feet, along its normal if asked', () => {
    const scene = new Scene();
    const ball = mesh(scene, 'sphere', [0, 0, 0], [2, 2, 2]);
    const surface = new SurfaceSampler([ball], false);
    const settings = arrangement({ kind: 'scatter', count: 100, aligns: true, height: 0.25 });
    for (const { position, turn } of scatteredPlaces(settings, surface, [0.5])) {
      const place = new Vector3(...position);
      // a sphere of 48 by 24 faces is up to 1 % smaller than its radius of 1 m
      expect(Math.abs(place.length() - 1.75)).toBeLessThan(0.02);
      const [x, y, z, w] = turn!;
      const up = new Vector3(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x));
      expect(up.angleTo(place)).toBeLessThan(0.15);
    }
    scene.dispose();
  });
});

describe('SurfaceBelow', () => {
  it('finds the surface below, else the one above, else the ground', () => {
    const scene = new Scene();
    const table = mesh(scene, 'box', [0, 1, 0], [2, 0.2, 2]);
    const hill = mesh(scene, 'box', [10, 2, 0], [2, 4, 2], { instanced: true });
    const below = new SurfaceBelow(scene, new Set());
    expect(below.heightAt({ x: 0, y: 3, z: 0 })).toBeCloseTo(1.1, 5);
    expect(below.heightAt({ x: 10, y: 1, z: 0 })).toBeCloseTo(4, 5);
    expect(below.heightAt({ x: 5, y: 3, z: 0 })).toBe(0);
    expect(new SurfaceBelow(scene, new Set([table, hill])).heightAt({ x: 0, y: 3, z: 0 })).toBe(0);
    scene.dispose();
  });
});
