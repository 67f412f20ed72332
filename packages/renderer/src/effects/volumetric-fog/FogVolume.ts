import { BoxGeometry, Color, Mesh, RawShaderMaterial } from 'three';

/** Material that three draws a volume with: nothing visible; VolumetricFog reads the object. */
const nothing = new RawShaderMaterial({
  name: 'Farol fog volume',
  transparent: true,
  depthTest: false,
  depthWrite: false,
  vertexShader: 'void main() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }',
  fragmentShader: 'precision mediump float; void main() { gl_FragColor = vec4(0.0); }',
});
nothing.allowOverride = false;
const box = new BoxGeometry();

/** Shapes of a volume of fog. */
export const fogShapes = ['box', 'sphere'] as const;

/** Names of the shapes of a volume of fog. */
export type FogShape = (typeof fogShapes)[number];

/**
 * Fog in a box or an ellipsoid, added to the scene's: a unit cube, or the ball in it, around the object's origin, sized
 * by `scale` (m). Without the effect `VolumetricFog` it is invisible.
 *
 * @example
 * const mist = new FogVolume('sphere');
 * mist.scale.set(6, 2, 6);
 * mist.density = 0.4;
 * scene.add(mist);
 */
export class FogVolume extends Mesh {
  readonly isFogVolume = true;
  /** Extinction coefficient (1/m) in the middle; below 0 it removes other fog, as inside a room. Default 0.2. */
  density = 0.2;
  /** Share of the extinguished light that is scattered, not absorbed, by colour (linear). Default white. */
  readonly albedo = new Color(1, 1, 1);
  /** Share of the distance from edge to middle over which the fog reaches its density, 0 to 1. Default 0.5. */
  softness = 0.5;

  constructor(public shape: FogShape = 'box') {
    super(box, nothing);
    this.name = 'Fog volume';
  }

  /** Does nothing: raycasters do not hit fog. */
  override raycast(): void {}
}
