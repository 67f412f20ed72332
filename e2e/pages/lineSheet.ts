import * as THREE from 'three';

/** Pixels along a side of the square that each line lies in. */
export const CELL = 48;
const COLUMNS = 12;

/** A line of the sheet. */
export interface SheetLine {
  readonly name: string;
  /** Left and lower pixel of its square. */
  readonly x: number;
  readonly y: number;
  /** Whether it runs along x more than along y. */
  readonly shallow: boolean;
}

/** Angles from the x axis (degrees), and what a line of that angle is. */
const angles: Readonly<Record<string, number>> = {
  horizontal: 0,
  'nearly horizontal': 2,
  shallow: 11,
  'less shallow': 26.565,
  'nearly diagonal': 40,
  diagonal: 45,
  steep: 71,
  'nearly vertical': 87,
  vertical: 90,
};

const kinds: readonly { readonly name: string; readonly line: number; readonly ground: number }[] = [
  { name: 'bright on dark', line: 0.9, ground: 0.02 },
  { name: 'dark on bright', line: 0.02, ground: 0.9 },
  { name: 'grey on grey', line: 0.35, ground: 0.2 },
];

/** Ribbons of triangles along curves, so many pixels wide. */
function ribbons(curves: readonly (readonly THREE.Vector2[])[], width: number): THREE.BufferGeometry {
  const positions: number[] = [];
  const indices: number[] = [];
  for (const points of curves) {
    const first = positions.length / 3;
    points.forEach((point, i) => {
      const before = points[Math.max(0, i - 1)];
      const after = points[Math.min(points.length - 1, i + 1)];
      const across = new THREE.Vector2(before.y - after.y, after.x - before.x).setLength(width / 2);
      positions.push(point.x + across.x, point.y + across.y, 0, point.x - across.x, point.y - across.y, 0);
      const at = first + 2 * i;
      if (i > 0) indices.push(at - 2, at - 1, at, at, at - 1, at + 1);
    });
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setIndex(indices);
  return geometry;
}

const straight = (degrees: number): THREE.Vector2[] => {
  const half = new THREE.Vector2(17, 0).rotateAround(new THREE.Vector2(), THREE.MathUtils.degToRad(degrees));
  return [half.clone().negate(), half];
};

/** A quarter of a circle, which has all slopes, flat enough to run along x. */
const arc = (): THREE.Vector2[] =>
  Array.from({ length: 33 }, (_, i) => {
    const angle = Math.PI * (0.25 + (0.5 * i) / 32);
    return new THREE.Vector2(-24 * Math.cos(angle), 24 * Math.sin(angle) - 20);
  });

/** Lines that cross one another, turned by an angle (degrees). */
const grid = (degrees: number): THREE.Vector2[][] =>
  [0, 90].flatMap((turn) =>
    [-14, -7, 0, 7, 14].map((off) =>
      [-19, 19].map((along) =>
        new THREE.Vector2(along, off).rotateAround(new THREE.Vector2(), THREE.MathUtils.degToRad(degrees + turn)),
      ),
    ),
  );

/** A sheet of thin lines, each in a square of its own, seen so that a unit is a pixel. */
export function lineSheet(): {
  scene: THREE.Scene;
  camera: THREE.Camera;
  width: number;
  height: number;
  lines: readonly SheetLine[];
} {
  const scene = new THREE.Scene();
  const shapes = Object.entries(angles).map(([name, degrees]) => ({
    name,
    curves: [straight(degrees)],
    shallow: degrees <= 45,
  }));
  shapes.push({ name: 'curved', curves: [arc()], shallow: true });
  shapes.push({ name: 'horizontal and vertical grid', curves: grid(0), shallow: true });
  shapes.push({ name: 'turned grid', curves: grid(9), shallow: true });
  const entries = kinds.flatMap((kind) =>
    [1, 1.5, 2].flatMap((width) => shapes.map((shape) => ({ ...shape, ...kind, width, shape: shape.name }))),
  );
  const width = COLUMNS * CELL;
  const height = Math.ceil(entries.length / COLUMNS) * CELL;
  const lines = entries.map(({ shape, name, width, curves, shallow, line, ground }, i): SheetLine => {
    const x = (i % COLUMNS) * CELL;
    const y = Math.floor(i / COLUMNS) * CELL;
    const square = new THREE.Mesh(
      new THREE.PlaneGeometry(CELL, CELL),
      new THREE.MeshBasicMaterial({ color: new THREE.Color(ground, ground, ground) }),
    );
    const strip = new THREE.Mesh(
      ribbons(curves, width),
      new THREE.MeshBasicMaterial({ color: new THREE.Color(line, line, line), side: THREE.DoubleSide }),
    );
    // off the grid of pixels, by another part of one for each
    const off = ((i * 7) % 10) / 10 - 0.45;
    square.position.set(x + CELL / 2, y + CELL / 2, 0);
    strip.position.set(x + CELL / 2 + off, y + CELL / 2 + off, 1);
    scene.add(square, strip);
    return { name: `${shape}, ${width} px, ${name}`, x, y, shallow };
  });
  const camera = new THREE.OrthographicCamera(0, width, height, 0, 0, 10);
  camera.position.z = 5;
  return { scene, camera, width, height, lines };
}
