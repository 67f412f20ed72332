import { AudioSource, Camera, Decal, FogVolume, type GameObject, Light, type Scene } from '@farol/engine';
import { Box3, Matrix4, OrthographicCamera, Vector3 } from 'three';
import type { LineSet } from './LineSet';

const unprojected = new Matrix4();
const clip = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
const reach = new Box3();
const centre = new Vector3();
const x = new Vector3();
const y = new Vector3();
const z = new Vector3();
const from = new Vector3();
const to = new Vector3();
const start = new Vector3();
const end = new Vector3();

/** Adds three circles about `centre`, in the planes of the axes. */
function drawSphere(lines: LineSet, radius: number, segments = 64): void {
  x.set(radius, 0, 0);
  y.set(0, radius, 0);
  z.set(0, 0, radius);
  lines.circle(centre, x, y, segments);
  lines.circle(centre, y, z, segments);
  lines.circle(centre, z, x, segments);
}

/** Adds the sphere within which a sound has its full volume and, if it ends at a distance, the sphere of its range. */
function drawSound(lines: LineSet, source: AudioSource): void {
  if (!source.positional) return;
  centre.setFromMatrixPosition(source.gameObject.object3D.matrixWorld);
  drawSphere(lines, source.referenceDistance);
  if (source.falloff === 'linear') drawSphere(lines, source.maxDistance);
}

/**
 * Adds the outline of an area light and an arrow in the direction of its light; a cylinder for a tube. `x`, `y` and `z`
 * hold its axes (unit length); `z` is its front.
 */
function drawShape(lines: LineSet, { type, width, height }: Light, segments: number): void {
  if (type === 'tube') {
    const radius = height / 2;
    from.copy(centre).addScaledVector(x, width / -2);
    to.copy(centre).addScaledVector(x, width / 2);
    y.multiplyScalar(radius);
    z.multiplyScalar(radius);
    lines.circle(from, y, z, segments);
    lines.circle(to, y, z, segments);
    for (const side of [y, z]) {
      for (const sense of [1, -1]) {
        lines.line(start.copy(from).addScaledVector(side, sense), end.copy(to).addScaledVector(side, sense));
      }
    }
    return;
  }
  to.copy(centre).addScaledVector(z, Math.max(0.25, 0.5 * Math.max(width, height)));
  lines.line(centre, to);
  x.multiplyScalar(width / 2);
  y.multiplyScalar(height / 2);
  if (type === 'disc') {
    lines.circle(centre, x, y, segments);
    return;
  }
  start.copy(centre).add(x).add(y);
  for (const [right, up] of [
    [-1, 1],
    [-1, -1],
    [1, -1],
    [1, 1],
  ]) {
    end.copy(centre).addScaledVector(x, right).addScaledVector(y, up);
    lines.line(start, end);
    start.copy(end);
  }
}

/**
 * Adds a sphere for a point light, cone of a spot light, arrow of a directional light, outline and range of an area
 * light.
 * @param segments - per circle
 */
function drawLight(lines: LineSet, light: Light, segments = 64): void {
  const { matrixWorld } = light.gameObject.object3D;
  centre.setFromMatrixPosition(matrixWorld);
  x.setFromMatrixColumn(matrixWorld, 0).normalize();
  y.setFromMatrixColumn(matrixWorld, 1).normalize();
  z.setFromMatrixColumn(matrixWorld, 2).normalize().negate();
  const reach = Math.min(light.reach, 1000);
  if (light.isArea) {
    drawShape(lines, light, segments);
    if (Number.isFinite(light.reach)) drawSphere(lines, reach + Math.hypot(light.width, light.height) / 2, segments);
  } else if (light.type === 'point' && Number.isFinite(light.reach)) drawSphere(lines, reach, segments);
  else if (light.type === 'spot') {
    const length = Number.isFinite(light.reach) ? reach : 5;
    const radius = Math.min(length * Math.tan(Math.min(light.cutoff, 1.5)), length * 4);
    to.copy(centre).addScaledVector(z, length);
    x.multiplyScalar(radius);
    y.multiplyScalar(radius);
    lines.circle(to, x, y, segments);
    for (const side of [x, y]) {
      lines.line(centre, from.copy(to).add(side));
      lines.line(centre, from.copy(to).sub(side));
    }
  } else if (light.type === 'directional') {
    to.copy(centre).addScaledVector(z, 3);
    lines.line(centre, to);
    x.multiplyScalar(0.25);
    y.multiplyScalar(0.25);
    lines.circle(centre, x, y, 24);
    from.copy(to).addScaledVector(z, -0.5);
    lines.line(to, centre.copy(from).add(x));
    lines.line(to, centre.copy(from).sub(x));
  }
}

/** Adds the frustum of a camera; that of a perspective camera is drawn only up to a short distance. */
function drawCamera(lines: LineSet, camera: Camera): void {
  const { three } = camera;
  three.updateWorldMatrix(true, false);
  unprojected.copy(three.projectionMatrixInverse);
  if (three instanceof OrthographicCamera) {
    lines.box(clip, unprojected.premultiply(three.matrixWorld));
    return;
  }
  centre.setFromMatrixPosition(three.matrixWorld);
  const length = Math.min(camera.far, 3);
  const corners = [-1, 1, 1, -1].map((right, i) => {
    const point = new Vector3(right, i < 2 ? -1 : 1, 0.5).applyMatrix4(three.projectionMatrixInverse);
    return point.multiplyScalar(-length / point.z).applyMatrix4(three.matrixWorld);
  });
  corners.forEach((each, i) => {
    lines.line(centre, each);
    lines.line(each, corners[(i + 1) % 4]);
  });
}

/** Adds the projection box of a decal, and an arrow in the direction of projection. */
function drawDecal(lines: LineSet, { gameObject, size }: Decal): void {
  const { matrixWorld } = gameObject.object3D;
  x.fromArray(size).multiplyScalar(0.5);
  lines.box(reach.set(y.copy(x).negate(), x), matrixWorld);
  const [width, height] = size;
  from.set(0, 0, x.z).applyMatrix4(matrixWorld);
  to.set(0, 0, -x.z).applyMatrix4(matrixWorld);
  lines.line(from, to);
  const tip = 0.15 * Math.min(width, height);
  for (const side of [-tip, tip]) lines.line(to, from.set(side, 0, tip - x.z).applyMatrix4(matrixWorld));
}

/** Adds the box or ellipsoid of a fog volume. */
function drawFog(lines: LineSet, { gameObject, shape, size }: FogVolume): void {
  const { matrixWorld } = gameObject.object3D;
  from.fromArray(size).multiplyScalar(0.5);
  if (shape === 'box') {
    lines.box(reach.set(to.copy(from).negate(), from), matrixWorld);
    return;
  }
  centre.setFromMatrixPosition(matrixWorld);
  x.setFromMatrixColumn(matrixWorld, 0).multiplyScalar(from.x);
  y.setFromMatrixColumn(matrixWorld, 1).multiplyScalar(from.y);
  z.setFromMatrixColumn(matrixWorld, 2).multiplyScalar(from.z);
  lines.circle(centre, x, y, 64);
  lines.circle(centre, y, z, 64);
  lines.circle(centre, z, x, 64);
}

/** Adds the ranges of all enabled lights of a scene; with fewer segments when there are many. */
export function drawRanges(lines: LineSet, scene: Scene): void {
  const lights = scene.componentsOf(Light);
  const segments = Math.min(48, Math.max(8, Math.round(20_000 / lights.length)));
  for (const light of lights) if (light.isActive) drawLight(lines, light, segments);
}

/** Maximum number of selected lights whose ranges are all drawn; more would hide the scene. */
const MOST_RANGES = 8;

/**
 * Adds lines for the selection: ranges of lights and sounds, frustums of cameras, boxes of decals and fog. Beyond `MOST_RANGES`
 * lights, only the range of the one selected last.
 */
export function drawSelection(lines: LineSet, objects: readonly GameObject[], lookThrough: Camera | null): void {
  let lights = 0;
  let last: GameObject | null = null;
  for (const object of objects) {
    if (!object.getComponent(Light)) continue;
    lights++;
    last = object;
  }
  for (const object of objects) {
    const light = object.getComponent(Light);
    const camera = object.getComponent(Camera);
    if (light && (lights <= MOST_RANGES || object === last)) drawLight(lines, light);
    const decal = object.getComponent(Decal);
    if (camera && camera !== lookThrough) drawCamera(lines, camera);
    if (decal) drawDecal(lines, decal);
    const fog = object.getComponent(FogVolume);
    if (fog) drawFog(lines, fog);
    const sound = object.getComponent(AudioSource);
    if (sound) drawSound(lines, sound);
  }
}
