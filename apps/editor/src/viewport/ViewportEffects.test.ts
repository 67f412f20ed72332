import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { ViewportEffects } from './ViewportEffects';

function renderer(...passes: string[]) {
  const farol = { effects: [] as FarolEffect[], info: { passes: passes.map((name) => ({ name })) } };
  return farol as unknown as FarolRenderer & typeof farol;
}
const names = ({ effects }: { effects: readonly FarolEffect[] }) => effects.map(({ name }) => name);
const failed = (error: unknown): never => {
  throw error;
};

describe('ViewportEffects', () => {
  // it is large, and else late in its first test
  beforeAll(() => import('@farol/renderer/effects') as Promise<unknown>);

  it('smooths edges by SMAA where a G-buffer is shaded, once its code is there, else leaves them to the canvas', async () => {
    const farol = renderer('g-buffer', 'output');
    const redraw = vi.fn<() => void>();
    const effects = new ViewportEffects(farol, redraw, failed);
    effects.update();
    expect(names(farol)).toEqual([]);
    await vi.waitFor(() => expect(names(farol)).toEqual(['SMAA']));
    expect(redraw).toHaveBeenCalledTimes(1);
    effects.update();
    expect(redraw).toHaveBeenCalledTimes(1);
    effects.suspended = true;
    expect(names(farol)).toEqual([]);
    effects.suspended = false;
    expect(names(farol)).toEqual(['SMAA']);
    farol.info.passes = [{ name: 'opaque' }] as never;
    effects.update();
    expect(names(farol)).toEqual([]);
    expect(redraw).toHaveBeenCalledTimes(4);
  });

  it('takes what is chosen, the same objects again, and leaves the effects of others alone', async () => {
    const farol = renderer('opaque');
    const other = { name: 'other' } as FarolEffect;
    farol.effects = [other];
    const effects = new ViewportEffects(farol, () => {}, failed);
    effects.choice = { antialiasing: 'taa', on: ['ambient-occlusion'] };
    expect(effects.frames).toBeGreaterThan(1);
    await vi.waitFor(() => expect(names(farol)).toEqual(['other', 'ambient occlusion', 'TAA']));
    const [, occlusion] = farol.effects;
    effects.choice = { antialiasing: 'none', on: [] };
    expect(farol.effects).toEqual([other]);
    expect(effects.frames).toBe(1);
    effects.choice = { antialiasing: 'none', on: ['ambient-occlusion'] };
    expect(farol.effects[1]).toBe(occlusion);
  });

  it('takes effects of plugins before those that smooth edges, and gives them back when the plugin goes', async () => {
    const farol = renderer('opaque');
    const effects = new ViewportEffects(farol, vi.fn<() => void>(), failed);
    effects.choice = { antialiasing: 'smaa', on: ['haze', 'unheard of'] };
    await vi.waitFor(() => expect(names(farol)).toEqual(['SMAA']));
    const dispose = vi.fn<() => void>();
    const make = (): FarolEffect => ({ name: 'Haze', dispose }) as unknown as FarolEffect;
    const takeOut = effects.added.add({ id: 'haze', label: 'Haze', help: 'Far things fade.', make });
    expect(names(farol)).toEqual(['Haze', 'SMAA']);
    takeOut();
    expect(names(farol)).toEqual(['SMAA']);
    expect(dispose).toHaveBeenCalledTimes(1);
    effects.added.add({ id: 'haze', label: 'Haze', help: 'Far things fade.', make });
    expect(names(farol)).toEqual(['Haze', 'SMAA']);
    expect(dispose).toHaveBeenCalledTimes(1);
  });
});
