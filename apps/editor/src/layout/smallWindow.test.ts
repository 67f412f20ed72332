import { expect, it } from 'vitest';
import { isSmallWindow, placeSheet, SHEET_TABS } from './smallWindow';

it('calls a telephone, a small laptop and a window enlarged twice small, and a tablet or a desktop not', () => {
  const small = [
    [390, 844],
    [844, 390],
    [640, 360],
    [720, 450],
    [800, 600],
  ];
  const large = [
    [820, 1180],
    [1024, 768],
    [1280, 720],
    [900, 560],
  ];
  expect(small.filter(([width, height]) => !isSmallWindow(width, height))).toEqual([]);
  expect(large.filter(([width, height]) => isSmallWindow(width, height))).toEqual([]);
});

it('fills the dock with picture, line, panel and tabs, whatever its size and share', () => {
  for (const [width, height] of [
    [390, 780],
    [800, 540],
    [640, 300],
    [10, 20],
  ]) {
    for (const share of [null, 0.2, 0.5, 0.8]) {
      const { main, sheet, edge, tabs, isBelow } = placeSheet(width, height, share);
      expect(tabs.height).toBe(SHEET_TABS);
      if (!sheet || !edge) {
        expect(share).toBe(null);
        expect(main.width).toBe(width);
        continue;
      }
      const parts = [main, edge, sheet];
      const sum = parts.reduce((all, part) => all + (isBelow ? part.height : part.width), 0);
      expect(sum).toBe(isBelow ? Math.max(0, height - SHEET_TABS) : width);
      expect(edge[isBelow ? 'y' : 'x']).toBe(main[isBelow ? 'height' : 'width']);
    }
  }
});
