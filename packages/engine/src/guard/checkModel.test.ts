import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { Slices } from '../base/Slices';
import { checkModel } from './checkModel';

describe('large models', () => {
  afterEach(() => {
    vi.restoreAllMocks();
  });

  /** A mesh of many vertices and triangles. */
  const large = (count: number): Mesh => {
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(count * 3), 3));
    geometry.setIndex(
      new BufferAttribute(
        Uint32Array.from({ length: count }, (_, i) => i),
        1,
      ),
    );
    return new Mesh(geometry);
  };

  /** Makes the clock advance by 1 ms at each reading. */
  const clock = (): void => {
    let now = 0;
    vi.spyOn(performance, 'now').mockImplementation(() => now++);
  };

  test('an index beyond the vertices is named', async () => {
    const mesh = large(9);
    mesh.name = 'Wall';
    mesh.geometry.index!.setX(4, 9);
    await expect(checkModel(mesh)).rejects.toThrow(/^the mesh 'Wall' has the index 9, and 9 vertices/);
  });

  test('are checked in slices, and the page has its turn between them', async () => {
    clock();
    const next = vi.spyOn(Slices.prototype, 'next');
    let hasTurn = false;
    setImmediate(() => (hasTurn = true));
    await checkModel(large(2_000_000));
    expect(hasTurn).toBe(true);
    // 123 clock readings for the vertices, 123 for the index; a yield at every 20th
    expect(next.mock.calls.length).toBeGreaterThanOrEqual(10);
  });

  test('a check that is cancelled ends', async () => {
    clock();
    const control = new AbortController();
    setImmediate(() => control.abort());
    const mesh = large(2_000_000);
    const read = vi.spyOn(mesh.geometry.getAttribute('position'), 'getComponent');
    await expect(checkModel(mesh, control.signal)).rejects.toMatchObject({ name: 'AbortError' });
    expect(read).not.toHaveBeenCalled();
  });
});
