import {
  AmbientLight,
  BoxGeometry,
  Camera,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshDepthMaterial,
  MeshStandardMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  Scene,
  ShaderMaterial,
} from 'three';
import { expect, it } from 'vitest';
import { isWorthFarol } from './isWorthFarol';

const camera = new PerspectiveCamera();
const geometry = new BoxGeometry();

function sceneOf(...materials: (Material | Material[])[]): Scene {
  const scene = new Scene();
  for (const material of materials) scene.add(new Group().add(new Mesh(geometry, material)));
  return scene;
}

it('is worth it for what is lit, and for what is too much to look at', () => {
  expect(isWorthFarol(sceneOf(new MeshBasicMaterial(), new MeshStandardMaterial()), camera, false)).toBe(true);
  expect(isWorthFarol(sceneOf([new MeshBasicMaterial(), new MeshStandardMaterial()]), camera, false)).toBe(true);
  expect(isWorthFarol(new Mesh(geometry, new MeshStandardMaterial()), camera, false)).toBe(true);
  expect(isWorthFarol(sceneOf(...Array.from({ length: 100 }, () => new MeshBasicMaterial())), camera, false)).toBe(
    true,
  );
});

it('leaves full-screen triangles, pictures of depth and unlit scenes to three', () => {
  const triangle = new Mesh(geometry, new ShaderMaterial());
  const screen = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  expect(isWorthFarol(triangle, screen, true)).toBe(false);
  expect(isWorthFarol(new Scene().add(triangle), screen, true)).toBe(false);
  const lit = sceneOf(new MeshStandardMaterial());
  expect(isWorthFarol(lit, new Camera(), false)).toBe(false);
  lit.overrideMaterial = new MeshDepthMaterial();
  expect(isWorthFarol(lit, camera, true)).toBe(false);
  lit.overrideMaterial = new MeshStandardMaterial();
  expect(isWorthFarol(lit, camera, false)).toBe(true);
  expect(isWorthFarol(sceneOf(new MeshBasicMaterial()).add(new AmbientLight()), camera, false)).toBe(false);
});

it('draws an unlit scene where effects are to be seen on it', () => {
  const scene = sceneOf(new MeshBasicMaterial(), new MeshBasicMaterial());
  expect(isWorthFarol(scene, camera, true)).toBe(true);
  expect(isWorthFarol(Object.assign(scene, { isFarolView: true }), camera, true)).toBe(false);
});
