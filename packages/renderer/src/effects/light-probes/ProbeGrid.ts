import { Data3DTexture, DataUtils, HalfFloatType, LinearFilter, RGBAFormat, Vector3 } from 'three';
import { type ProbeBox, probeCount } from './ProbeBox';

/** Count of a probe's numbers: nine coefficients each of red, green and blue, in the order of three's SphericalHarmonics3. */
export const PROBE_NUMBERS = 27;
/** Number of the 3D texture's texels for a probe's 27 numbers. */
const TEXELS = 7;

/**
 * Light at the middles of a box's cells, as spherical harmonics of second order, in one half-float 3D texture: seven volumes
 * stacked along z, each with an extra slice at either end, so that filtering does not mix volumes.
 */
export class ProbeGrid {
  readonly texture: Data3DTexture;
  readonly min = new Vector3();
  readonly max = new Vector3();
  readonly counts = new Vector3();

  /**
   * @param coefficients - coefficients of radiance, 27 a probe, in the order of `probePoints`
   * @throws RangeError when their number does not match the box's probes
   */
  constructor(
    readonly box: ProbeBox,
    coefficients: Float32Array,
  ) {
    const count = probeCount(box);
    if (coefficients.length !== PROBE_NUMBERS * count) {
      throw new RangeError(
        `ProbeGrid: ${coefficients.length} coefficients for ${count} probes; give ${PROBE_NUMBERS * count}.`,
      );
    }
    this.min.fromArray(box.min);
    this.max.fromArray(box.max);
    this.counts.fromArray(box.counts);
    const [width, height, depth] = box.counts;
    const texture = new Data3DTexture(pack(box, coefficients), width, height, TEXELS * (depth + 2));
    texture.format = RGBAFormat;
    texture.type = HalfFloatType;
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.unpackAlignment = 1;
    texture.needsUpdate = true;
    this.texture = texture;
  }

  dispose(): void {
    this.texture.dispose();
  }
}

/** Largest half float. */
const LARGEST = 65504;
const half = (value: number): number => DataUtils.toHalfFloat(Math.min(Math.max(value, -LARGEST), LARGEST));

function pack({ counts }: ProbeBox, coefficients: Float32Array): Uint16Array<ArrayBuffer> {
  const [width, height, depth] = counts;
  const slice = 4 * width * height;
  const data = new Uint16Array(slice * TEXELS * (depth + 2));
  for (let volume = 0; volume < TEXELS; volume++) {
    for (let padded = 0; padded < depth + 2; padded++) {
      const z = Math.min(Math.max(padded - 1, 0), depth - 1);
      let at = slice * (volume * (depth + 2) + padded);
      for (let i = 0; i < width * height; i++) {
        const from = PROBE_NUMBERS * (z * width * height + i) + 4 * volume;
        for (let c = 0; c < 4; c++) data[at++] = 4 * volume + c < PROBE_NUMBERS ? half(coefficients[from + c]) : 0;
      }
    }
  }
  return data;
}
