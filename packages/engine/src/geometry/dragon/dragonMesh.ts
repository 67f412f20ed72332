import type { Vector3Tuple } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import { createRandom } from '../../base/createRandom';
import { fitGeometry } from '../fitGeometry';
import { MeshBuilder } from '../MeshBuilder';
import { round, type Section, Sweep } from './Sweep';

/** Centre line of the body, from the nape to the tip of the tail (m, before the mesh is scaled to its final size). */
const body = new Sweep([
  [-0.39, 0.54, 0],
  [-0.32, 0.575, 0.01],
  [-0.245, 0.52, 0.03],
  [-0.225, 0.4, 0.035],
  [-0.24, 0.27, 0.01],
  [-0.16, 0.185, -0.03],
  [-0.03, 0.215, -0.05],
  [0.07, 0.29, -0.03],
  [0.17, 0.275, 0.03],
  [0.245, 0.175, 0.06],
  [0.335, 0.085, 0.05],
  [0.43, 0.115, 0],
  [0.465, 0.225, -0.04],
  [0.405, 0.3, -0.05],
  [0.345, 0.265, -0.03],
]);

/** Number of scales round the body and along it, and of the mesh's cells across a scale and along it. */
const SCALES = { round: 16, along: 96, across: 4, rows: 2 };

const smooth = (from: number, to: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - from) / (to - from)));
  return t * t * (3 - 2 * t);
};

/** Radius of the body (m): slim at the neck, stout between the legs, thin at the tail. */
const girth = (v: number): number =>
  0.042 + 0.04 * smooth(0.08, 0.38, v) - 0.03 * smooth(0.46, 0.68, v) - 0.0445 * smooth(0.6, 1, v);

/** Cross-section with scales on the back and flanks, and broad plates on the belly. */
const hide: Section = (u, v) => {
  const angle = 2 * Math.PI * u;
  const row = v * SCALES.along;
  const shift = Math.floor(row) % 2 === 0 ? 0 : 0.5;
  const [along, across] = [row % 1, (u * SCALES.round + shift) % 1];
  // the rear edge of each scale overlaps the next scale
  const scale = along ** 1.5 * (1 - (2 * across - 1) ** 2);
  const isBelly = smooth(-0.55, -0.8, Math.sin(angle));
  const radius = girth(v) * (1 + (1 - isBelly) * 0.13 * scale + isBelly * 0.06 * along);
  return [radius * Math.cos(angle), radius * (1.12 - 0.1 * isBelly) * Math.sin(angle)];
};

/** Adds a tapering tube with a round end: a horn, whisker, claw or toe. */
function horn(mesh: MeshBuilder, points: readonly Vector3Tuple[], radius: number, columns = 8, rows = 10): void {
  const section = round((v) => radius * (1 - v) ** 0.8 + 1e-4);
  mesh.surface(columns, rows, new Sweep(points).surface(section));
}

/** Adds a ball (an eye or a nostril) to the mesh. */
function ball(mesh: MeshBuilder, [x, y, z]: Vector3Tuple, radius: number): void {
  mesh.at(x, y, z).lathe(14, 9, (v) => [radius * Math.sin(Math.PI * v), -radius * Math.cos(Math.PI * v)]);
  mesh.at(0, 0, 0);
}

function addBody(mesh: MeshBuilder): void {
  mesh.surface(SCALES.round * SCALES.across, SCALES.along * SCALES.rows, body.surface(hide));
  // a fin at the end of the tail
  const fin: Section = (u, v) => {
    const angle = 2 * Math.PI * u;
    const width = 0.055 * Math.sin(Math.PI * v ** 0.7) + 1e-4;
    return [0.007 * (1 - v) * Math.cos(angle), width * Math.sin(angle)];
  };
  const tip = new Sweep([body.at(0.97), body.at(1), [0.305, 0.215, -0.015], [0.29, 0.15, 0]]);
  mesh.surface(24, 24, tip.surface(fin));
}

/** Spines along the back, the tallest over the shoulders. */
function addSpines(mesh: MeshBuilder, random: () => number): void {
  const count = 38;
  for (let i = 0; i < count; i++) {
    const v = 0.02 + (0.76 * i) / count;
    const height = (0.03 + 0.035 * Math.sin(Math.PI * smooth(0, 0.85, v))) * (0.85 + 0.3 * random()) * (1 - 0.5 * v);
    const base = girth(v);
    const root = body.at(v, 0, base * 0.8);
    const middle = body.at(Math.min(1, v + 0.008), 0, base + height * 0.6);
    const peak = body.at(Math.min(1, v + 0.026), 0, base + height);
    const blade: Section = (u, w) => {
      const angle = 2 * Math.PI * u;
      const size = (1 - w) ** 0.9 + 1e-3;
      return [0.005 * size * Math.cos(angle), 0.017 * size * (1 - 0.4 * v) * Math.sin(angle)];
    };
    mesh.surface(8, 6, new Sweep([root, middle, peak]).surface(blade));
  }
}

/** Adds the head: skull and upper jaw, lower jaw, eyes, horns, a beard, teeth and whiskers. */
function addHead(mesh: MeshBuilder): void {
  const skull = new Sweep([
    [-0.36, 0.555, 0.004],
    [-0.41, 0.545, 0],
    [-0.46, 0.515, 0],
    [-0.52, 0.487, 0],
    [-0.565, 0.485, 0],
  ]);
  const upper: Section = (u, v) => {
    const angle = 2 * Math.PI * u;
    const cheeks = Math.exp(-(((v - 0.3) / 0.16) ** 2));
    const snout = Math.exp(-(((v - 0.86) / 0.1) ** 2));
    const end = Math.sqrt(Math.max(0, 1 - ((v - 0.9) / 0.1) ** 2));
    const close = v < 0.9 ? 1 : end;
    const width = (0.03 + 0.022 * cheeks + 0.007 * snout) * close + 1e-4;
    const height = (0.034 - 0.016 * smooth(0.3, 0.7, v) + 0.012 * cheeks + 0.007 * snout) * close + 1e-4;
    // flat below, with a ridge from the brows to the nose
    const ridge = 1 + 0.18 * Math.max(0, -Math.sin(angle)) ** 6;
    const sine = Math.sin(angle);
    return [width * Math.cos(angle), (sine > 0 ? 0.55 : ridge) * height * sine];
  };
  mesh.surface(36, 44, skull.surface(upper));
  const jaw = new Sweep([
    [-0.4, 0.525, 0],
    [-0.44, 0.488, 0],
    [-0.49, 0.448, 0],
    [-0.535, 0.432, 0],
  ]);
  const lower: Section = (u, v) => {
    const angle = 2 * Math.PI * u;
    const close = Math.sqrt(Math.max(0, 1 - Math.max(0, (v - 0.8) / 0.2) ** 2));
    const size = close * (1 - 0.4 * v) + 1e-4;
    return [0.034 * size * Math.cos(angle), 0.016 * size * Math.sin(angle)];
  };
  mesh.surface(24, 24, jaw.surface(lower));
  for (const side of [-1, 1]) {
    const z = (x: number): number => side * x;
    ball(mesh, [-0.452, 0.545, z(0.031)], 0.0125);
    ball(mesh, [-0.556, 0.496, z(0.016)], 0.0065);
    // brow, two horns, an ear
    horn(
      mesh,
      [
        [-0.478, 0.548, z(0.024)],
        [-0.45, 0.566, z(0.032)],
        [-0.41, 0.578, z(0.04)],
      ],
      0.011,
    );
    horn(
      mesh,
      [
        [-0.42, 0.568, z(0.022)],
        [-0.375, 0.625, z(0.04)],
        [-0.3, 0.655, z(0.055)],
        [-0.215, 0.645, z(0.052)],
      ],
      0.0155,
      14,
      28,
    );
    horn(
      mesh,
      [
        [-0.385, 0.545, z(0.04)],
        [-0.345, 0.56, z(0.068)],
        [-0.295, 0.55, z(0.078)],
      ],
      0.013,
    );
    // whisker and the beard's locks
    horn(
      mesh,
      [
        [-0.555, 0.482, z(0.024)],
        [-0.575, 0.44, z(0.055)],
        [-0.545, 0.385, z(0.075)],
        [-0.49, 0.355, z(0.07)],
      ],
      0.0045,
      8,
      26,
    );
    for (const [i, x] of [-0.4, -0.425, -0.45].entries()) {
      horn(
        mesh,
        [
          [x, 0.505 - 0.018 * i, z(0.03)],
          [x + 0.035, 0.462 - 0.018 * i, z(0.046)],
          [x + 0.06, 0.405 - 0.02 * i, z(0.042)],
        ],
        0.0105,
      );
    }
    for (let i = 0; i < 6; i++) {
      const x = -0.47 - 0.014 * i;
      const tall = i === 4 ? 0.03 : 0.017;
      horn(
        mesh,
        [
          [x, 0.492 - 0.003 * i, z(0.023 - 0.0012 * i)],
          [x - 0.001, 0.484 - tall / 2, z(0.0225)],
          [x, 0.482 - tall, z(0.02)],
        ],
        0.0048,
        6,
        6,
      );
    }
  }
}

/** Adds a leg: thigh, shin and four toes with claws. @param hip - joint at the body @param foot - its heel */
function addLeg(mesh: MeshBuilder, hip: Vector3Tuple, knee: Vector3Tuple, foot: Vector3Tuple): void {
  const leg = new Sweep([hip, knee, [foot[0] + 0.012, foot[1] + 0.055, foot[2]], foot]);
  const muscle = round((v) => 0.022 + 0.04 * Math.exp(-(((v - 0.16) / 0.24) ** 2)) + 0.004 * smooth(0.8, 1, v));
  mesh.surface(20, 28, leg.surface(muscle));
  horn(
    mesh,
    [
      [knee[0] + 0.01, knee[1], knee[2]],
      [knee[0] + 0.05, knee[1] + 0.02, knee[2]],
      [knee[0] + 0.085, knee[1] + 0.055, knee[2]],
    ],
    0.014,
  );
  for (let toe = 0; toe < 4; toe++) {
    const isSpur = toe === 3;
    const turn = isSpur ? Math.PI : (toe - 1) * 0.55;
    const [x, z] = [-Math.cos(turn), Math.sin(turn)];
    const place = (reach: number, y: number): Vector3Tuple => [foot[0] + reach * x, y, foot[2] + reach * z];
    const long = isSpur ? 0.6 : 1;
    const claw = new Sweep([
      place(0, 0.03),
      place(0.035 * long, 0.036),
      place(0.062 * long, 0.017),
      place(0.07 * long, 0.014),
    ]);
    mesh.surface(10, 9, claw.surface(round((v) => 0.0155 * (1 - 0.45 * v) * Math.sqrt(1.0001 - v ** 8))));
    horn(mesh, [place(0.06 * long, 0.02), place(0.082 * long, 0.024), place(0.098 * long, 0.002)], 0.0085);
  }
}

/**
 * A dragon of 48,000 triangles, made in code: as detailed as the Stanford dragon, whose licence restricts its use. 1 m
 * long (x, its head at -x), standing on y = 0.
 */
export function dragonMesh(): BufferGeometry {
  const mesh = new MeshBuilder();
  const random = createRandom(7);
  addBody(mesh);
  addSpines(mesh, random);
  addHead(mesh);
  addLeg(mesh, [-0.205, 0.27, 0.05], [-0.15, 0.15, 0.125], [-0.225, 0.012, 0.11]);
  addLeg(mesh, [-0.205, 0.27, -0.05], [-0.24, 0.17, -0.125], [-0.33, 0.012, -0.115]);
  addLeg(mesh, [0.15, 0.26, 0.075], [0.19, 0.15, 0.14], [0.105, 0.012, 0.14]);
  addLeg(mesh, [0.15, 0.26, -0.03], [0.2, 0.16, -0.115], [0.16, 0.012, -0.12]);
  return fitGeometry(mesh.build(Math.PI / 3));
}
