import type { FarolRenderer } from '@farol/renderer';
import { interceptRender } from '@farol/renderer/intercept';
import { setShading } from '@farol/renderer';
import { getSurfaces, setSurface } from '@farol/renderer/surfaces';
import { FloatType, type Light, type Material, type Mesh, type Object3D, WebGLRenderTarget } from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import type { LiveModule } from '../LiveModule';
import type { StillClock } from './StillClock';

/** Lights of stock three's that fit into its uniforms, and shadow maps that fit into its texture units. */
const MOST_LIGHTS = 20;
const MOST_SHADOWS = 3;

/** Pictures of one moment of a live module. */
export interface BothPictures {
  /** [height, width, 4], linear RGBA, bottom row first. */
  readonly stock: Float32Array;
  readonly farol: Float32Array;
  /** Technique that drew. */
  readonly technique: string;
  /** Parts of the scene that stock three cannot draw, and that neither picture has. */
  readonly leftOut: readonly string[];
}

/**
 * Draws a live module's scene by stock three and by its own FarolRenderer, into linear floats. Takes away first what stock
 * three has no means for; the page is of no use afterwards.
 */
export async function drawBoth(
  clock: StillClock,
  live: LiveModule,
  width: number,
  height: number,
): Promise<BothPictures> {
  const [farol, webgl, scene, camera] = await Promise.all([live.farol!, live.webgl!, live.scene!, live.camera!]);
  await clock.until(farol.ready);
  const leftOut = [...takeAway(farol), ...takeFromScene(scene)];
  RectAreaLightUniformsLib.init();
  const { technique } = farol.info;
  if (farol.technique === 'auto') farol.technique = technique as FarolRenderer['technique'];
  const target = new WebGLRenderTarget(width, height, { type: FloatType });
  const interception = interceptRender(webgl, (scene, camera, next) => next(scene, camera));
  const drawBy = (draw: () => void): Float32Array => {
    const pixels = new Float32Array(4 * width * height);
    const before = webgl.getRenderTarget();
    webgl.setRenderTarget(target);
    webgl.clear();
    draw();
    webgl.setRenderTarget(before);
    webgl.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    return pixels;
  };
  webgl.setAnimationLoop(null);
  await farol.compileAsync(scene, camera);
  const pictures = {
    farol: drawBy(() => farol.render(scene, camera)),
    stock: drawBy(() => interception.stock(scene, camera)),
  };
  interception.remove();
  target.dispose();
  return { ...pictures, technique, leftOut };
}

/** Resets what stock three has no equal of, settings and microshaders. @returns names of those that were in use */
function takeAway(farol: FarolRenderer): string[] {
  const leftOut: string[] = farol.effects.map(({ name }) => name);
  farol.effects = [];
  farol.view = 'final';
  farol.budget = null;
  if (farol.quality === 'lite') leftOut.push("quality 'lite'");
  farol.quality = 'full';
  farol.antialias = false;
  farol.areaLightThreshold = 0;
  if (farol.lightLayers) leftOut.push('light layers');
  farol.lightLayers = false;
  if (farol.shadowCascades > 1) leftOut.push('cascades');
  farol.shadowCascades = 1;
  const { microshaders } = farol;
  for (const name of microshaders.names()) {
    if (microshaders.original(name) === undefined) continue;
    try {
      microshaders.remove(name);
      leftOut.push(`microshader ${name}`);
    } catch {
      // `remove` throws for a chunk that was never edited: nothing to reset
    }
  }
  return leftOut;
}

function takeFromScene(scene: Object3D): Set<string> {
  const leftOut = new Set<string>();
  let lights = 0;
  let shadows = 0;
  scene.traverseVisible((object) => {
    const { material } = object as Mesh<never, Material | Material[]>;
    for (const each of material === undefined ? [] : [material].flat()) {
      if (each.userData.farol?.shading === 'gouraud') leftOut.add('Gouraud shading');
      setShading(each, null);
      if (getSurfaces(each).length === 0) continue;
      setSurface(each, null);
      leftOut.add('surfaces');
    }
    if ('isLightField' in object || 'isParticleEmitter' in object) {
      object.visible = false;
      leftOut.add('isLightField' in object ? 'light fields' : 'particles');
    }
    if (!('isLight' in object) || !object.visible) return;
    const light = object as Light;
    const { farol, farolMap, farolProfile, ...others } = light.userData;
    if (farol || farolMap || farolProfile) leftOut.add('options of lights');
    light.userData = others;
    if (light.castShadow && ('isRectAreaLight' in light || ++shadows > MOST_SHADOWS)) {
      light.castShadow = false;
      leftOut.add(`shadows but ${MOST_SHADOWS}`);
    }
    if (++lights <= MOST_LIGHTS) return;
    light.visible = false;
    leftOut.add(`lights but ${MOST_LIGHTS}`);
  });
  return leftOut;
}
