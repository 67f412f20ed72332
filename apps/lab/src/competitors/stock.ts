import type { Material } from 'three';
import { deviceLimits } from '../stage/deviceLimits';
import type { StageScene } from '../stage/StageScene';
import type { Competitor, Drawing } from './Competitor';
import { competitorNames } from './competitorNames';
import { createWebGL } from './createWebGL';

/** Uniform vectors of a point light: position and distance, colour and decay; of its shadow: two of numbers, one of size. */
const LIGHT = 2;
const SHADOW = 3;
/** Uniform vectors that a material needs besides. */
const OTHERS = 16;
/** From so many lights on, programs are linked beside the page, which would hang meanwhile. */
const MANY = 64;

/** three's own renderer: every light is in every shader. */
export const stock: Competitor = {
  ...{ name: 'stock', label: competitorNames.stock.label, help: competitorNames.stock.help, kind: 'three' },
  unavailable: async () => null,
  refuses({ lights, shadows }) {
    const { fragmentUniforms, textures } = deviceLimits();
    const needed = lights * LIGHT + shadows * SHADOW + OTHERS;
    if (needed > fragmentUniforms) {
      const most = Math.floor((fragmentUniforms - OTHERS - shadows * SHADOW) / LIGHT);
      return `Its shader holds ${most} lights at most on this device (${fragmentUniforms} uniform vectors), not ${lights}.`;
    }
    if (shadows > textures) {
      return `Its shader holds ${textures} textures on this device: too few for the shadow maps of ${shadows} lights.`;
    }
    return null;
  },
  async open(canvas, scene, signal): Promise<Drawing> {
    const { three, camera, lights, still } = scene;
    refuseTextures(scene);
    const { renderer, gl, check, dispose } = createWebGL(canvas, scene);
    const many = lights.length + still.length >= MANY;
    return {
      gl,
      render: () => renderer.render(three, camera),
      check,
      ...(many && {
        async drawFirst() {
          await renderer.compileAsync(three, camera);
          signal.throwIfAborted();
          renderer.render(three, camera);
        },
      }),
      dispose,
    };
  },
};

/** @throws Error where shadow maps and the textures of a material are more than a shader can hold */
function refuseTextures({ three, lights, still }: StageScene): void {
  const shadows = [...lights, ...still].filter(({ castShadow }) => castShadow).length;
  if (shadows === 0) return;
  let most = 0;
  three.traverse((object) => {
    const { material } = object as { material?: Material | Material[] };
    for (const each of [material ?? []].flat()) {
      const own = Object.values(each).filter((value) => (value as { isTexture?: boolean } | null)?.isTexture).length;
      most = Math.max(most, own + (three.environment ? 1 : 0));
    }
  });
  const { textures } = deviceLimits();
  if (shadows + most > textures) {
    throw new Error(
      `Its shader holds ${textures} textures on this device, ${most} of them the material’s: shadows of ` +
        `${textures - most} lights at most, not of ${shadows}.`,
    );
  }
}
