import { expect, test } from 'vitest';
import { AtlasPlacement } from './AtlasPlacement';

test('a map has one region at a time', () => {
  const placement = new AtlasPlacement();
  const region = { x: 8, y: 16, width: 36, height: 24 };
  placement.place(region, 10, 10, 1);
  expect(placement).toMatchObject({ region, faceWidth: 10, faceHeight: 10, border: 1 });
  expect(() => placement.place(region, 10, 10, 1)).toThrow('release it');
  placement.drop();
  expect(placement.region).toBeNull();
  placement.place(region, 5, 5, 2);
  expect(placement.border).toBe(2);
});
