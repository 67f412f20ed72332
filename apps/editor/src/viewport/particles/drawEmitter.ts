import type { ParticleEmitter } from '@farol/engine';
import { Box3, Matrix4, Vector3 } from 'three';
import type { LineSet } from '../LineSet';

/** Height of the upper circle of a cone (m). */
const CONE_HEIGHT = 1;
/** Half of the side of the square drawn for a collision plane (m). */
const PLANE_REACH = 2;
/** Radius of the sphere drawn for an emitter that is a point (m). */
const POINT = 0.15;

const centre = new Vector3();
const x = new Vector3();
const y = new Vector3();
const z = new Vector3();
const from = new Vector3();
const to = new Vector3();
const place = new Vector3();
const ball = new Matrix4();
const box = new Box3();

type Triple = readonly [number, number, number];

/** Adds a circle around the emitter's y axis. */
function ring(lines: LineSet, matrix: Matrix4, radius: number, height: number): void {
  centre.set(0, height, 0).applyMatrix4(matrix);
  x.setFromMatrixColumn(matrix, 0).multiplyScalar(radius);
  z.setFromMatrixColumn(matrix, 2).multiplyScalar(radius);
  lines.circle(centre, x, z, 48);
}

function sphere(lines: LineSet, matrix: Matrix4, radius: number): void {
  centre.setFromMatrixPosition(matrix);
  x.setFromMatrixColumn(matrix, 0).multiplyScalar(radius);
  y.setFromMatrixColumn(matrix, 1).multiplyScalar(radius);
  z.setFromMatrixColumn(matrix, 2).multiplyScalar(radius);
  lines.circle(centre, x, y, 48);
  lines.circle(centre, y, z, 48);
  lines.circle(centre, z, x, 48);
}

function cone(lines: LineSet, matrix: Matrix4, radius: number, angle: number): void {
  // an almost flat cone gets a smaller height, so that it is not drawn too wide
  const height = CONE_HEIGHT * Math.min(1, Math.max(Math.cos(angle) * 2, 0.02));
  const top = radius + height * Math.tan(Math.min(angle, 1.5));
  ring(lines, matrix, radius, 0);
  ring(lines, matrix, top, height);
  for (let i = 0; i < 4; i++) {
    const [c, s] = [Math.cos((i * Math.PI) / 2), Math.sin((i * Math.PI) / 2)];
    from.set(radius * c, 0, radius * s).applyMatrix4(matrix);
    to.set(top * c, height, top * s).applyMatrix4(matrix);
    lines.line(from, to);
  }
}

/** Adds a collision plane of particles, around its point closest to the emitter, with its normal. */
function plane(lines: LineSet, normal: Triple, height: number, place: Vector3): void {
  y.fromArray(normal).normalize();
  x.set(1, 0, 0).cross(y);
  if (x.lengthSq() < 0.01) x.set(0, 0, 1).cross(y);
  x.normalize().multiplyScalar(PLANE_REACH);
  z.copy(x).cross(y);
  centre.copy(place);
  centre.addScaledVector(y, height - centre.dot(y));
  const corners = [-1, 1, 1, -1].map((side, i) =>
    new Vector3()
      .copy(centre)
      .addScaledVector(x, side)
      .addScaledVector(z, i < 2 ? -1 : 1),
  );
  corners.forEach((corner, i) => lines.line(corner, corners[(i + 1) % 4]));
  lines.line(centre, to.copy(centre).addScaledVector(y, 0.4));
}

/** Adds the emission shape of an emitter and its collision plane. */
export function drawEmitter(lines: LineSet, emitter: ParticleEmitter): void {
  const { shape, radius, angle, boxSize, gameObject } = emitter;
  const { matrixWorld } = gameObject.object3D;
  if (shape === 'cone') cone(lines, matrixWorld, radius, angle);
  else if (shape === 'sphere') sphere(lines, matrixWorld, radius);
  else if (shape === 'box') {
    to.fromArray(boxSize).multiplyScalar(0.5);
    lines.box(box.set(from.copy(to).negate(), to), matrixWorld);
  } else if (shape === 'point') sphere(lines, matrixWorld, POINT);
  const colliders = emitter.three?.colliders ?? [];
  for (const [i, collider] of colliders.entries()) {
    if (collider.kind === 'sphere') ball.makeScale(collider.radius, collider.radius, collider.radius);
    if (collider.kind === 'sphere') sphere(lines, ball.setPosition(...collider.center), 1);
    else
      plane(
        lines,
        collider.normal,
        collider.height,
        i === 0 ? place.setFromMatrixPosition(matrixWorld) : place.fromArray(emitter.colliderPoses[i - 1].position),
      );
  }
}
