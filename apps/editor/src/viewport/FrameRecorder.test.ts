import { describe, expect, it } from 'vitest';
import { FrameRecorder } from './FrameRecorder';
import { gridCells, LABEL } from './painters/gridCells';

const pass = (name: string, cpuMs: number, gpuMs: number | null = null) => ({
  name,
  cpuMs,
  gpuMs,
  drawCalls: 0,
  triangles: 0,
});

describe('FrameRecorder', () => {
  it('keeps the last frames, and forgets a pass that runs no more', () => {
    const recorder = new FrameRecorder(4);
    recorder.add({ passes: [pass('a', 1), pass('b', 2, 5)] });
    recorder.add({ passes: [pass('a', 3, 1), pass('a', 1)] });
    const [a, b] = recorder.passes;
    expect([...a.cpu]).toEqual([1, 4, -1, -1]);
    expect(recorder.mean(a, 'cpu')).toBe(2.5);
    expect(recorder.mean(b, 'gpu')).toBe(5);
    expect(recorder.longest('cpu')).toBe(4);
    for (let i = 0; i < 4; i++) recorder.add({ passes: [pass('c', 1)] });
    expect(recorder.passes.map(({ name }) => name)).toEqual(['c']);
    expect(recorder.mean(recorder.passes[0], 'gpu')).toBeNull();
  });

  it('puts GPU times that come later to the frame they are of', () => {
    const recorder = new FrameRecorder(4);
    for (let i = 0; i < 5; i++) recorder.add({ passes: [pass('a', 1)] });
    recorder.addTimes({ passes: [pass('a', 1, 7), pass('unknown', 1, 3)] });
    expect([...recorder.passes[0].gpu]).toEqual([7, -1, -1, -1]);
  });
});

describe('gridCells', () => {
  it.each([
    [11, 800, 500],
    [11, 300, 900],
    [1, 640, 360],
  ])('puts %i pictures into %i by %i, of its form, apart from one another', (count, width, height) => {
    const cells = gridCells(count, width, height);
    expect(cells).toHaveLength(count);
    for (const [i, a] of cells.entries()) {
      expect(Math.abs(a.width / a.height - width / height)).toBeLessThan(0.1);
      expect(a.x).toBeGreaterThanOrEqual(0);
      expect(a.y).toBeGreaterThanOrEqual(LABEL);
      expect(a.x + a.width).toBeLessThanOrEqual(width);
      expect(a.y + a.height).toBeLessThanOrEqual(height);
      for (const b of cells.slice(i + 1)) {
        const apart =
          a.x + a.width <= b.x ||
          b.x + b.width <= a.x ||
          a.y + a.height <= b.y - LABEL ||
          b.y + b.height <= a.y - LABEL;
        expect(apart).toBe(true);
      }
    }
  });
});
