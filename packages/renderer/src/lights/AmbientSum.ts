import { type HemisphereLight, type Light, type Matrix4, Vector3 } from 'three';

const direction = new Vector3();
const skyColour: [number, number, number] = [0, 0, 0];
const groundColour: [number, number, number] = [0, 0, 0];

/** The ambient and hemisphere lights of a frame in one sum: a linear function of the view-space normal. */
export class AmbientSum {
  /** Constant and three slopes (x, y, z of the view-space normal) of the irradiance, 4 × RGB. */
  readonly values = new Float32Array(12);

  clear(): void {
    this.values.fill(0);
  }

  addAmbient(light: Light): void {
    const { color, intensity } = light;
    this.values[0] += color.r * intensity;
    this.values[1] += color.g * intensity;
    this.values[2] += color.b * intensity;
  }

  /** mix(ground, sky, 0.5 n·up + 0.5) = 0.5 (sky + ground) + n · 0.5 (sky - ground) up. */
  addHemisphere(light: HemisphereLight, view: Matrix4): void {
    const up = direction.setFromMatrixPosition(light.matrixWorld).transformDirection(view);
    light.color.toArray(skyColour);
    light.groundColor.toArray(groundColour);
    for (let c = 0; c < 3; c++) {
      const sky = skyColour[c] * light.intensity;
      const ground = groundColour[c] * light.intensity;
      this.values[c] += 0.5 * (sky + ground);
      const slope = 0.5 * (sky - ground);
      this.values[3 + c] += slope * up.x;
      this.values[6 + c] += slope * up.y;
      this.values[9 + c] += slope * up.z;
    }
  }
}
