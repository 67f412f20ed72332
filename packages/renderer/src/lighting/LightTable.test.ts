import { PerspectiveCamera, PointLight, SpotLight } from 'three';
import { describe, expect, it } from 'vitest';
import { FLOATS_PER_RECORD, LIGHT } from '../lights/lightRecord';
import type { LightMasks } from './LightRecords';
import { LightTable } from './LightTable';
import { rankByDepth } from '../techniques/light-lists/rankByDepth';
import { rankByGrid } from '../techniques/light-lists/rankByGrid';

const camera = new PerspectiveCamera(60, 1, 0.1, 100);
camera.updateMatrixWorld();
const settings = { shadows: 'all', layers: null } as const;
const size = { width: 64, height: 64 };
const ranks = { 'by-volume': null, 'by-depth': rankByDepth, 'by-grid': rankByGrid } as const;
/** Masks as they are until the code of masks is loaded. */
const without: LightMasks = { records: 0, recordOf: () => -1, write: () => {} };

describe('the light table', () => {
  it.each(['by-volume', 'by-depth', 'by-grid'] as const)(
    'counts by their records which lights are plain (%s)',
    (order) => {
      const point = new PointLight(0xffffff, 1, 5);
      point.castShadow = true;
      const spot = new SpotLight(0xffffff, 1, 5, 0.5);
      for (const light of [point, spot]) {
        light.position.z = -10;
        light.updateMatrixWorld();
      }
      const table = new LightTable();
      table.collect([point, spot], camera, settings);
      table.write(camera, order, size, without, ranks[order]);
      const isPlain = Array.from({ length: table.bounded }, (_, k) => {
        const emission = (table.firstBounded + k) * FLOATS_PER_RECORD + LIGHT.emission;
        return table.table.data[emission + 3] >= 0;
      });
      expect(isPlain.filter((plain) => plain)).toHaveLength(1);
      expect(table.extendedCount).toBe(1);
    },
  );

  it.each([
    ['plain, between quads of plain point lights and the others', 'by-depth', true, true, 128, 3],
    ['plain, after plain point lights alone', 'by-depth', true, false, 2, 3],
    ['with spot lights, after all', 'by-depth', false, true, 129, 1],
    ['with spot lights, from a quad on that is walked by the general loop', 'by-depth', false, false, 2, 0],
    ['in volumes, after all', 'by-volume', true, true, 3, 0],
  ] as const)('makes room for the records of fields: %s', (_, order, plain, withSpot, first, quads) => {
    const lights = [new PointLight(0xffffff, 1, 5), new PointLight(0xffffff, 1, 5)];
    const spot = new SpotLight(0xffffff, 1, 5, 0.5);
    spot.userData.farol = { ambient: [1, 1, 1] };
    const all = withSpot ? [...lights, spot] : lights;
    for (const light of all) {
      light.position.z = -10;
      light.updateMatrixWorld();
    }
    const table = new LightTable();
    table.collect(all, camera, settings);
    table.slots = 256;
    table.plainSlots = plain;
    table.write(camera, order, size, without, ranks[order]);
    expect(table.firstSlot - table.firstBounded).toBe(first);
    expect(table.listed).toBe(table.bounded + 256);
    if (order === 'by-depth') expect(table.plainQuads).toBe(quads);
    if (!withSpot) return;
    // the spot light's extension record follows the records of fields
    const record = table.firstBounded + table.bounded - 1;
    const extension = table.table.data[record * FLOATS_PER_RECORD + LIGHT.details + 3];
    expect(extension).toBe(table.recordCount - 1 + 256);
  });
});
