import { WebGLRenderTarget } from 'three';
import type { TechniqueName } from '@farol/renderer';
import { Bench, type PageImage } from '../Bench';
import { compareImages } from '../../support/images';
import type { CaseResult } from './runSheet';
import { settings } from './settings';
import { isSlice, techniqueInTurn } from '../techniquesInTurn';
import { type Render, type Setting, Stage } from './Stage';

const WIDTH = 96;
const HEIGHT = 64;

/** The canvas's picture as linear floats. */
function readCanvas(bench: Bench): PageImage {
  const { webgl } = bench;
  const gl = webgl.getContext();
  const bytes = new Uint8Array(WIDTH * HEIGHT * 4);
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  const linear = (value: number) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
  return { width: WIDTH, height: HEIGHT, data: Float32Array.from(bytes, (byte) => linear(byte / 255)) };
}

function readTarget(bench: Bench, target: Bench['target']): PageImage {
  const { type } = target.texture;
  const raw =
    type === bench.target.texture.type ? new Float32Array(WIDTH * HEIGHT * 4) : new Uint8Array(WIDTH * HEIGHT * 4);
  bench.webgl.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, raw);
  return {
    width: WIDTH,
    height: HEIGHT,
    data: raw instanceof Float32Array ? raw : Float32Array.from(raw, (byte) => byte / 255),
  };
}

/** Draws the stage under each setting by stock three and by each technique; in the slice by one of them in turn. */
export function runSettings(names: readonly string[], techniques: readonly TechniqueName[]): CaseResult[] {
  const benches = new Map<string, Bench>();
  return names.flatMap((name, index) => {
    const setting: Setting = settings[name];
    if (isSlice && setting.inVerify) return [];
    const key = JSON.stringify(setting.renderer ?? {});
    let bench = benches.get(key);
    if (bench === undefined) {
      bench = new Bench(WIDTH, HEIGHT, setting.renderer ? { renderer: setting.renderer } : {});
      bench.farol.inferredScale = 1;
      benches.set(key, bench);
    }
    const { webgl, farol } = bench;
    const target = setting.target ? new WebGLRenderTarget(WIDTH, HEIGHT, setting.target) : bench.target;
    const stage = new Stage(bench, WIDTH, HEIGHT);
    setting.prepare?.(stage);
    const draw = setting.draw ?? (({ scene, camera }: Stage, render: Render) => render(scene, camera));
    const picture = (technique: TechniqueName | null) => {
      webgl.setRenderTarget(setting.canvas ? null : target);
      if (technique !== null) farol.technique = technique;
      draw(
        stage,
        (scene, camera) => (technique === null ? webgl : farol).render(scene, camera),
        technique === null ? null : farol,
      );
      const image = setting.canvas ? readCanvas(bench) : readTarget(bench, target);
      webgl.setRenderTarget(null);
      const error = webgl.getContext().getError();
      if (error !== 0) throw new Error(`${name}, ${technique}: WebGL error ${error}`);
      return image;
    };
    const stock = picture(null);
    return techniqueInTurn(index, techniques)
      .filter((technique) => !setting.except?.(technique))
      .map((technique) => ({
        sheet: setting.canvas || setting.target ? 'settings, 8 bits' : 'settings',
        case: name,
        technique,
        ...compareImages(stock, picture(technique)),
      }));
  });
}
