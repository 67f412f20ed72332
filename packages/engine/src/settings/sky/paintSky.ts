import { createRandom } from '../../base/createRandom';
import { cloudNoise } from './cloudNoise';
import type { SkyBox, SkyClouds, SkyDisc, SkyLook } from './skyLooks';

const smooth = (from: number, to: number, value: number): number => {
  const share = Math.min(1, Math.max(0, (value - from) / (to - from)));
  return share * share * (3 - 2 * share);
};

/** Direction of a disc or box as x, y, z. */
function directionOf({ elevation, azimuth }: SkyDisc | SkyBox): [number, number, number] {
  return [Math.cos(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.sin(azimuth) * Math.cos(elevation)];
}

/** Cosine of the angle from the sun beyond which its glow is not computed: there it is below 1e-12 of its maximum. */
const GLOWING = 0.88;

/** Cloud in a direction above the horizon: cover and lit share, both 0 to 1. */
const cloud = { share: 0, lit: 0 };

function lookAtClouds({ cover }: SkyClouds, sun: readonly number[] | null, x: number, y: number, z: number): void {
  const far = 1.4 / (y + 0.12);
  const px = x * far;
  const py = z * far;
  const density = cloudNoise(px + 40, py + 40, 5);
  const edge = 0.78 - 0.56 * cover;
  cloud.share = smooth(edge, edge + 0.2, density) * smooth(0.01, 0.2, y);
  if (cloud.share === 0) return;
  // density a little nearer to the sun: where it is lower than here, the sun lights this side of the cloud
  const toSun = sun === null ? 0 : 0.22;
  const behind = cloudNoise(px + 40 + toSun * (sun?.[0] ?? 0), py + 40 + toSun * (sun?.[2] ?? 0), 4);
  cloud.lit = sun === null ? 1 - smooth(0.35, 0.7, density) : Math.min(1, Math.max(0, 0.55 + 3.2 * (density - behind)));
}

/** Adds stars above the horizon with random positions, sizes and tints, the same in every run. */
function addStars(count: number, pixels: Float32Array, width: number, height: number): void {
  const random = createRandom(11);
  for (let i = 0; i < count; i++) {
    const y = random() * 2 - 1;
    const column = Math.floor(random() * width);
    const brightness = 0.05 + 1.6 * random() ** 7;
    const warm = random() - 0.5;
    if (y < 0.03) continue;
    const row = Math.floor((Math.asin(y) / Math.PI + 0.5) * height);
    const at = (row * width + column) * 3;
    pixels[at] += brightness * (1 + 0.35 * warm);
    pixels[at + 1] += brightness;
    pixels[at + 2] += brightness * (1 - 0.35 * warm);
  }
}

/**
 * Paints a sky as an equirectangular picture, bottom row first, as in three's textures.
 * @returns linear radiance: red, green, blue of each pixel
 */
export function paintSky(look: SkyLook, width: number, height: number): Float32Array {
  const pixels = new Float32Array(width * height * 3);
  const { top, horizon, ground, disc, clouds, boxes } = look;
  const sun = disc && directionOf(disc);
  const lamps = boxes.map((box) => ({ box, to: directionOf(box) }));
  const edge = disc ? Math.cos(disc.radius) : 2;
  const softEdge = disc ? Math.cos(disc.radius * 1.5) : 2;
  const cosines = new Float64Array(width);
  const sines = new Float64Array(width);
  for (let column = 0; column < width; column++) {
    const angle = ((column + 0.5) / width - 0.5) * 2 * Math.PI;
    cosines[column] = Math.cos(angle);
    sines[column] = Math.sin(angle);
  }
  for (let row = 0, at = 0; row < height; row++) {
    const elevation = ((row + 0.5) / height - 0.5) * Math.PI;
    const y = Math.sin(elevation);
    const flat = Math.cos(elevation);
    const isUp = y >= 0;
    const low = 1 - 0.7 * smooth(0, 0.5, y);
    const share = isUp ? y ** 0.55 : smooth(0, 0.12, -y) * 0.75 + smooth(0.05, 1, -y) * 0.25;
    const far = isUp ? top : ground;
    const red = horizon[0] + (far[0] - horizon[0]) * share;
    const green = horizon[1] + (far[1] - horizon[1]) * share;
    const blue = horizon[2] + (far[2] - horizon[2]) * share;
    for (let column = 0; column < width; column++, at += 3) {
      const x = cosines[column] * flat;
      const z = sines[column] * flat;
      let r = red;
      let g = green;
      let b = blue;
      let open = isUp ? 1 : Math.max(0, 1 + y * 12);
      if (disc && sun && open > 0) {
        const near = Math.max(0, x * sun[0] + y * sun[1] + z * sun[2]);
        const cube = near * near * near;
        const haze = cube * cube * low * open;
        // farther away the glow is too small for a half float
        const glow = near > GLOWING ? near ** 220 * open : 0;
        r += disc.haze[0] * haze + disc.glow[0] * glow;
        g += disc.haze[1] * haze + disc.glow[1] * glow;
        b += disc.haze[2] * haze + disc.glow[2] * glow;
        if (!isUp) open = 0;
        const whole = smooth(softEdge, edge, near) * open;
        r += disc.colour[0] * whole;
        g += disc.colour[1] * whole;
        b += disc.colour[2] * whole;
      }
      if (clouds && y > 0.01) {
        lookAtClouds(clouds, sun, x, y, z);
        const { share: covered, lit } = cloud;
        const through = 1 - covered;
        r = r * through + (clouds.dark[0] + (clouds.light[0] - clouds.dark[0]) * lit) * covered;
        g = g * through + (clouds.dark[1] + (clouds.light[1] - clouds.dark[1]) * lit) * covered;
        b = b * through + (clouds.dark[2] + (clouds.light[2] - clouds.dark[2]) * lit) * covered;
      }
      for (const { box, to } of lamps) {
        if (x * to[0] + y * to[1] + z * to[2] <= 0.3) continue;
        const light = box.radiance * boxShare(box, to, x, y, z);
        r += light;
        g += light;
        b += light;
      }
      pixels[at] = r;
      pixels[at + 1] = g;
      pixels[at + 2] = b;
    }
  }
  if (look.stars > 0) addStars(look.stars, pixels, width, height);
  return pixels;
}

/** Coverage of a direction by a box: 1 inside, 0 outside, smooth at the edges. */
function boxShare(box: SkyBox, to: readonly number[], x: number, y: number, z: number): number {
  const { halfWidth, halfHeight, azimuth } = box;
  // axes of the box: a horizontal one, and one perpendicular to it and to the box's direction
  const rightX = -Math.sin(azimuth);
  const rightZ = Math.cos(azimuth);
  const across = Math.abs(x * rightX + z * rightZ);
  const upX = -to[1] * rightZ;
  const upY = to[0] * rightZ - to[2] * rightX;
  const upZ = to[1] * rightX;
  const along = Math.abs(x * upX + y * upY + z * upZ);
  return (
    (1 - smooth(Math.sin(halfWidth) - 0.04, Math.sin(halfWidth), across)) *
    (1 - smooth(Math.sin(halfHeight) - 0.04, Math.sin(halfHeight), along))
  );
}
