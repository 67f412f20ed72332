import { Matrix4, NoBlending, type Texture, Vector2, Vector3, Vector4 } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { LightLoop } from '../../materials/LightLoop';
import { MOST_COLLIDERS } from './checkParticleSetting';
import particleCurves from './particleCurves.glsl?raw';
import particleLighting from './particleLighting.glsl?raw';
import particleLights from './particleLights.glsl?raw';
import particleMotion from './particleMotion.glsl?raw';
import particleNoise from './particleNoise.glsl?raw';
import particleRandom from './particleRandom.glsl?raw';
import particleShape from './particleShape.glsl?raw';
import particleStep from './particleStep.glsl?raw';

const noTexture = () => ({ value: null as Texture | null });
const particles = () => ({ farol_particlePositions: noTexture(), farol_particleVelocities: noTexture() });

/** Makes the pass of one step of all particles of an emitter. */
export function particleStepPass() {
  return new FullscreenPass({
    program: 'particle step',
    fragment: 'particleStep',
    microShaders: { particleRandom, particleNoise, particleShape, particleMotion, particleStep },
    uniforms: {
      ...particles(),
      farol_particleSeed: { value: 0 },
      farol_emitterShape: { value: new Int32Array(2) },
      farol_emitterSize: { value: new Vector3() },
      farol_emitterSurface: noTexture(),
      farol_acceleration: { value: new Vector4() },
      farol_noise: { value: new Vector4() },
      farol_colliderCount: { value: 0 },
      farol_colliders: { value: Array.from({ length: MOST_COLLIDERS }, () => new Vector4()) },
      farol_bounces: { value: Array.from({ length: MOST_COLLIDERS }, () => new Vector3()) },
      farol_beginning: { value: new Int32Array(4) },
      farol_firstNumber: { value: 0 },
      farol_stepTimes: { value: new Vector3() },
      farol_emitterStart: { value: new Matrix4() },
      farol_emitterEnd: { value: new Matrix4() },
      farol_carried: { value: new Matrix4() },
      farol_lifeAndSpeed: { value: new Vector4() },
      farol_inherited: { value: new Vector3() },
    },
    blending: NoBlending,
    repeats: true,
  });
}

/** Makes the pass that writes the lights of an emitter's particles, in the layout of a LightField. */
export function particleLightsPass() {
  return new FullscreenPass({
    program: 'lights of particles',
    fragment: 'particleLights',
    microShaders: { particleCurves, particleLights },
    uniforms: {
      ...particles(),
      farol_particleCurves: noTexture(),
      farol_lightOf: { value: new Int32Array(3) },
      farol_lightValues: { value: new Vector2() },
    },
    blending: NoBlending,
    repeats: true,
  });
}

/** GLSL name of the pixel at a particle's centre, by which light loops find their lists, in place of gl_FragCoord. */
const COORDINATE = 'farol_listCoordinate';

/** Lists the names replaced in this program, for `checkLiveEdit`. */
const NAMES = `// names gl_FragCoord=${COORDINATE} FAROL_TEXEL=gl_FragCoord\n`;

/** @param parameters - program parameters, as passed to `Material.onBeforeCompile` */
function nameCoordinates(parameters: { fragmentShader: string }): void {
  parameters.fragmentShader = parameters.fragmentShader
    .replaceAll('gl_FragCoord', COORDINATE)
    .replaceAll('FAROL_TEXEL', 'gl_FragCoord')
    .replace('precision highp float;\n', `precision highp float;\n${NAMES}vec4 ${COORDINATE};\n`);
}

/** Computes the light on each particle of an emitter, by a light loop. */
export class ParticleLightingPass extends FullscreenPass<ReturnType<typeof lightingUniforms>> {
  private prepared: unknown = null;

  constructor(loop: LightLoop) {
    super({
      program: 'light on particles',
      fragment: [loop, 'particleLighting'],
      microShaders: { particleLighting },
      uniforms: lightingUniforms(),
      shared: 'all',
      blending: NoBlending,
      repeats: true,
    });
  }

  override draw(frame: Frame): void {
    const material = this.material(frame);
    if (material !== this.prepared) {
      this.prepared = material;
      material.onBeforeCompile = nameCoordinates;
      material.customProgramCacheKey = () => 'farol-light-on-particles';
    }
    super.draw(frame);
  }
}

function lightingUniforms() {
  return {
    ...particles(),
    farol_particleView: { value: new Matrix4() },
    farol_particleProjection: { value: new Matrix4() },
    farol_listPicture: { value: new Vector4() },
    farol_particlesShadowed: { value: false },
  };
}
