import { PointLight, Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { LightField } from './LightField';

/** Rows uploaded to a copy, as [first, rows]. */
function sent(field: LightField, seen: number, rows: number): { runs: number[][]; seen: number } {
  const runs: number[][] = [];
  const next = field.spheres.changes(seen, rows, (first, count) => runs.push([first, count]));
  return { runs, seen: next };
}

describe('a light field', () => {
  it('sends the rows of 128 lights that changed, to each copy what it lacks', () => {
    const field = new LightField(1000);
    const one = sent(field, field.spheres.whole(), 8);
    expect(one.runs).toEqual([]);
    const two = one.seen;
    field.setPosition(130, 1, 2, 3);
    field.setPosition(500, 1, 2, 3);
    field.spheres.update(390, 100);
    const first = sent(field, one.seen, 8);
    expect(first.runs).toEqual([
      [1, 1],
      [3, 1],
    ]);
    expect(sent(field, first.seen, 8).runs).toEqual([]);
    field.setRange(999, 2);
    // the other copy was not updated yet
    expect(sent(field, two, 8).runs).toEqual([
      [1, 1],
      [3, 1],
      [7, 1],
    ]);
    expect(sent(field, first.seen, 8).runs).toEqual([[7, 1]]);
  });

  it('sends rows behind those that are drawn once they are drawn', () => {
    const field = new LightField(512);
    const { seen } = sent(field, field.spheres.whole(), 4);
    field.setPosition(10, 1, 1, 1);
    field.setPosition(300, 1, 1, 1);
    const few = sent(field, seen, 1);
    expect(few.runs).toEqual([[0, 1]]);
    expect(field.spheres.hasChanged(few.seen, 1)).toBe(false);
    expect(field.spheres.hasChanged(few.seen, 4)).toBe(true);
    expect(sent(field, few.seen, 4).runs).toEqual([[2, 1]]);
  });

  it('holds what is set', () => {
    const field = new LightField(3, { spots: true });
    field.setPoint(1, 1, 2, 3, 4, 5, 6, 7, 1);
    field.setCone(1, 0, -5, 0, 0.5, 0.2);
    field.setPosition(1, -1, -2, -3);
    field.setEmission(1, 8, 9, 10);
    expect([...field.spheres.array.slice(4, 8)]).toEqual([-1, -2, -3, 4]);
    expect([...field.emissions.array.slice(4, 8)]).toEqual([8, 9, 10, 1]);
    const [x, y, z, w] = field.cones!.array.slice(4, 8);
    expect([x, z]).toEqual([0, 0]);
    expect(y).toBeCloseTo(-2 - Math.cos(0.4), 6);
    expect(w).toBeCloseTo(Math.cos(0.5), 6);
    const clone = field.clone();
    expect(clone.capacity).toBe(3);
    expect([...clone.cones!.array]).toEqual([...field.cones!.array]);
    expect(clone.spheres.array).not.toBe(field.spheres.array);
    field.setPoint(1, 0, 0, 0, 1, 1, 1, 1);
    expect([...field.cones!.array.slice(4, 8)]).toEqual([0, 0, 0, 0]);
  });

  it('is a light that three leaves alone', () => {
    const field = new LightField(1);
    expect([field.isLight, field.isLightField, field.color.getHex(), field.intensity]).toEqual([
      true,
      true,
      0xffffff,
      1,
    ]);
    expect((field as unknown as PointLight).isPointLight).toBeUndefined();
  });

  it('says what is wrong', () => {
    expect(() => new LightField(-1)).toThrow('capacity is -1');
    expect(() => new LightField(NaN)).toThrow(RangeError);
    expect(() => new LightField(2).setPosition(2, 0, 0, 0)).toThrow('there is no light 2; give an index below 2');
    expect(() => new LightField(2).setCone(0, 0, 1, 0, 1)).toThrow('make the field with { spots: true }');
    const textures = { sphere: new Texture(), emission: new Texture() };
    expect(() => new LightField(2, { textures }).setRange(0, 1)).toThrow('in textures; write those');
    expect(() => new LightField(2).copy(new LightField(3))).toThrow('use clone()');
  });
});
