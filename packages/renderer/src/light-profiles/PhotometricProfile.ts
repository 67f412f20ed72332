import {
  ClampToEdgeWrapping,
  DataTexture,
  DataUtils,
  HalfFloatType,
  LinearFilter,
  RedFormat,
  RepeatWrapping,
} from 'three';
import type { PhotometricData } from './PhotometricData';
import { findSteps } from './findSteps';
import { interpolate } from './interpolate';

const RADIANS = Math.PI / 180;

/**
 * The light of a luminaire by direction, in the frame of `setLightOptions`: vertical angle 0 is down, horizontal angle 0
 * is across. In a file of type B, vertical angles go from down to across, and horizontal angles clockwise, as in the
 * standard; one of type A, for luminaires that aim horizontally, is turned to aim down.
 *
 * @example
 * const profile = await new IESLoader().loadAsync('downlight.ies');
 * setLightOptions(light, { profile: profile.texture });
 * light.intensity = profile.maximumIntensity; // as bright as the file says; or any other, to shape the light alone
 */
export class PhotometricProfile {
  readonly isPhotometricProfile = true;
  name = '';
  /** Intensity in the brightest direction (cd), which is 1 in the texture. */
  readonly maximumIntensity: number;
  /** Factor on the lamps' light at the profile's tilt. */
  readonly tiltFactor: number;
  private made: DataTexture | null = null;

  /**
   * @param tilt - tilt of the luminaire from the position in which it was measured (degrees), for lamps that give less light
   *   when tilted
   */
  constructor(
    readonly data: PhotometricData,
    tilt = 0,
  ) {
    this.tiltFactor = data.tilt === null ? 1 : interpolate(data.tilt.angles, data.tilt.factors, 0, Math.abs(tilt));
    let most = 0;
    for (const candelas of data.candelas) most = Math.max(most, candelas);
    this.maximumIntensity = most * this.tiltFactor;
  }

  /** True if the light is equal at all horizontal angles. */
  get isRotational(): boolean {
    return this.data.type === 'C' && this.data.horizontalAngles.length === 1;
  }

  /** Luminous flux of all directions (lm). */
  get luminousFlux(): number {
    const rows = this.isRotational ? 1 : 360;
    let flux = 0;
    for (let v = 0.25; v < 180; v += 0.5) {
      let ring = 0;
      for (let row = 0; row < rows; row++) ring += this.intensityAt(v, (row * 360) / rows);
      flux += (ring / rows) * Math.sin(v * RADIANS);
    }
    return flux * 2 * Math.PI * 0.5 * RADIANS;
  }

  /**
   * Intensity in a direction (cd).
   * @param vertical - degrees from down, 0 to 180
   * @param horizontal - degrees, any
   */
  intensityAt(vertical: number, horizontal: number): number {
    return (
      this.tiltFactor *
      (this.data.type === 'C' ? this.planeAt(vertical, horizontal) : this.axisAt(vertical, horizontal))
    );
  }

  /**
   * Intensities as shares of `maximumIntensity`, for `LightOptions` (and three's IESSpotLight): half floats, one row if
   * `isRotational`. Created by the first read; the profile's `dispose` disposes it.
   */
  get texture(): DataTexture {
    return (this.made ??= this.makeTexture());
  }

  dispose(): void {
    this.made?.dispose();
    this.made = null;
  }

  private makeTexture(): DataTexture {
    const { columns, rows } = findSteps(this.data);
    const values = new Uint16Array(columns * rows);
    const scale = this.maximumIntensity > 0 ? 1 / this.maximumIntensity : 0;
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const value = this.intensityAt((column * 180) / (columns - 1), (row * 360) / rows) * scale;
        values[row * columns + column] = DataUtils.toHalfFloat(value);
      }
    }
    const texture = new DataTexture(values, columns, rows, RedFormat, HalfFloatType);
    texture.name = this.name;
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.wrapS = ClampToEdgeWrapping;
    texture.wrapT = RepeatWrapping;
    texture.needsUpdate = true;
    return texture;
  }

  /** Intensity (cd) towards two angles (degrees), for an IES file of photometry type C. */
  private planeAt(vertical: number, horizontal: number): number {
    const { horizontalAngles: angles } = this.data;
    const first = angles[0];
    const last = angles[angles.length - 1];
    const turned = ((horizontal % 360) + 360) % 360;
    if (last === first) return this.fileAt(vertical, first);
    let at = turned;
    if (first === 90) {
      // angles from 90 to 270 are mirrored in the plane of 90 and 270
      at = turned < 90 ? 180 - turned : turned > 270 ? 540 - turned : turned;
    } else if (last <= 180) {
      if (at > 180) at = 360 - at;
      if (last === 90 && at > 90) at = 180 - at;
    } else if (at > last) {
      // some files leave out the plane at 360, which equals that at 0
      const share = (at - last) / (360 - last);
      return (1 - share) * this.fileAt(vertical, last) + share * this.fileAt(vertical, first);
    }
    return this.fileAt(vertical, at);
  }

  /** Intensity (cd) towards two angles (degrees), for an IES file of type A or B. */
  private axisAt(vertical: number, horizontal: number): number {
    const sine = Math.sin(vertical * RADIANS);
    const down = Math.cos(vertical * RADIANS);
    const across = Math.cos(horizontal * RADIANS) * sine;
    // horizontal angles go clockwise, as seen from above
    const side = -Math.sin(horizontal * RADIANS) * sine;
    const isB = this.data.type === 'B';
    let v = (isB ? Math.atan2(across, down) : Math.asin(clampSine(across))) / RADIANS;
    let h = (isB ? Math.asin(clampSine(side)) : Math.atan2(side, down)) / RADIANS;
    if (this.data.verticalAngles[0] >= 0) v = Math.abs(v);
    const { horizontalAngles } = this.data;
    if (horizontalAngles[0] >= 0) h = Math.abs(h);
    const last = horizontalAngles[horizontalAngles.length - 1];
    if (horizontalAngles.length > 1 && (h < horizontalAngles[0] - 1e-9 || h > last + 1e-9)) return 0;
    return this.fileAt(v, h);
  }

  /** Intensity at the file's own angles; 0 beyond its vertical angles. */
  private fileAt(vertical: number, horizontal: number): number {
    const { verticalAngles: v, horizontalAngles: h, candelas } = this.data;
    const count = v.length;
    if (vertical < v[0] - 1e-9 || vertical > v[count - 1] + 1e-9) return 0;
    let plane = 0;
    while (plane < h.length - 2 && horizontal > h[plane + 1]) plane++;
    const before = interpolate(v, candelas, plane * count, vertical);
    if (h.length === 1 || horizontal <= h[plane]) return before;
    const share = Math.min(1, (horizontal - h[plane]) / (h[plane + 1] - h[plane]));
    return (1 - share) * before + share * interpolate(v, candelas, (plane + 1) * count, vertical);
  }
}

function clampSine(value: number): number {
  return Math.max(-1, Math.min(1, value));
}
