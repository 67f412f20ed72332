import { expect, it } from 'vitest';
import { PerspectiveCamera, PointLight, type WebGLRenderer } from 'three';
import { LightField } from '../light-fields/LightField';
import type { Frame } from '../frame/Frame';
import { LightTable } from '../lighting/LightTable';
import { readLightsInRows } from '../techniques/light-lists/readLights';
import { InfoRecorder } from './InfoRecorder';
import type { LastFrame } from './LastFrame';

const lights = { total: 7, visible: 3, uploadedBytes: 100 } as unknown as LightTable;

function makeRecorder() {
  const render = { calls: 50, triangles: 1000 };
  const canvas = new EventTarget();
  const webgl = { info: { render, programs: [1, 2] }, getContext: () => ({ canvas }) } as unknown as WebGLRenderer;
  let counts = 0;
  const recorder = new InfoRecorder(webgl, { pending: null } as unknown as LastFrame, (memory) => {
    Object.assign(memory, { gbuffer: 5, gbufferPixel: 16, lights: ++counts });
    return 5 + counts;
  });
  const draw = (name: string, calls: number, triangles: number) => {
    recorder.beginPass(name);
    render.calls += calls;
    render.triangles += triangles;
    recorder.endPass();
  };
  return { recorder, draw };
}

it('counts the draws and triangles of each pass, beside what the host has drawn before, and sums them up', () => {
  const { recorder, draw } = makeRecorder();
  const { info } = recorder;
  for (let frame = 0; frame < 2; frame++) {
    recorder.begin(false, 0);
    draw('g-buffer', 4, 240);
    draw('lighting', 1, 1);
    recorder.end('deferred', 'asked for', { lights, uploadedBytes: 28, isLite: true } as Frame, null);
    expect(info.passes.map(({ name, drawCalls, triangles }) => [name, drawCalls, triangles])).toEqual([
      ['g-buffer', 4, 240],
      ['lighting', 1, 1],
    ]);
    expect([info.drawCalls, info.triangles]).toEqual([5, 241]);
  }
  expect([info.technique, info.reason, info.programs]).toEqual(['deferred', 'asked for', 2]);
  expect([info.lights.total, info.lights.visible, info.uploadBytes]).toEqual([7, 3, 128]);
  expect(info.gpuMs).toBe(null);
  expect(info.quality).toBe('lite');
  // counted when read, outside of a frame
  expect(info.memory).toMatchObject({ gbuffer: 5, lights: 1, shadows: 0 });
  expect(info.targetBytes).toBe(5 + 2);
  recorder.dispose();
});

it('hints at LightField from 2,000 lights on that are objects of their own, and no longer once there are fewer', () => {
  readLightsInRows();
  const { recorder } = makeRecorder();
  const camera = new PerspectiveCamera();
  const many = Array.from({ length: 2000 }, () => new PointLight(0xffffff, 1, 1));
  const table = new LightTable();
  const hintOf = (all: (PointLight | LightField)[]): string | null => {
    table.collect(all, camera, { shadows: 'none', layers: null });
    recorder.begin(false, 0);
    recorder.end('deferred', 'asked for', { lights: table, uploadedBytes: 0, isLite: false } as Frame, null);
    return recorder.info.hint;
  };
  expect(recorder.info.hint).toBe(null);
  expect(hintOf(many)).toMatch(/2,000 lights .* LightField/);
  expect(hintOf([new LightField(5000), ...many.slice(1)])).toBe(null);
  expect(hintOf([new LightField(5000), ...many])).toMatch(/LightField/);
  expect(hintOf([])).toBe(null);
  recorder.dispose();
});
