import { createRandom } from '@farol/engine';
import { describe, expect, it } from 'vitest';
import { defaultLayout, type PlacedPanel } from './defaultLayout';
import { activatePanel, growPanel, movePanel, removePanel, resizeSplit } from './editLayout';
import { type DropSide, groupsOf, groupWith, type LayoutNode } from './LayoutNode';
import { openPanel } from './openPanel';
import { EDGE, moveEdge, placeLayout } from './placeLayout';
import { repairLayout } from './repairLayout';

const panels: readonly PlacedPanel[] = [
  { id: 'hierarchy', place: 'left' },
  { id: 'viewport', place: 'middle' },
  { id: 'inspector', place: 'right' },
  { id: 'history', place: 'right' },
  { id: 'assets', place: 'bottom' },
  { id: 'console', place: 'bottom' },
  { id: 'frame', place: 'right', isOpen: false },
];

function expectSound(layout: LayoutNode, ids: readonly string[]): void {
  const groups = groupsOf(layout);
  expect(new Set(groups.map(({ id }) => id)).size).toBe(groups.length);
  expect(groups.flatMap((group) => group.panels).toSorted()).toEqual(ids.toSorted());
  for (const { panels: some, active } of groups) expect(some).toContain(active);
  const visit = (node: LayoutNode): void => {
    if (node.kind === 'group') return;
    expect(node.children.length).toBeGreaterThan(1);
    expect(node.sizes.length).toBe(node.children.length);
    for (const size of node.sizes) expect(size).toBeGreaterThan(0);
    for (const child of node.children) {
      if (child.kind === 'split') expect(child.direction).not.toBe(node.direction);
      visit(child);
    }
  };
  visit(layout);
}

describe('the layout of panels', () => {
  it('begins with each panel at its place', () => {
    const layout = defaultLayout(panels);
    expect(groupsOf(layout).map((group) => group.panels)).toEqual([
      ['hierarchy'],
      ['viewport'],
      ['assets', 'console'],
      ['inspector', 'history'],
    ]);
    const { groups, edges } = placeLayout(layout, 1400, 800);
    expect(groups.find(({ group }) => group.id === 'middle')!.rectangle).toEqual({
      x: 250 + EDGE,
      y: 0,
      width: 1400 - 250 - 340 - 2 * EDGE,
      height: 800 - 190 - EDGE,
    });
    expect(edges).toHaveLength(3);
  });

  it('grows a panel at the bottom to a height, no other, and never makes one smaller', () => {
    const layout = defaultLayout(panels, 800, 1280);
    const heightOf = (grown: LayoutNode, id: string): number =>
      placeLayout(grown, 1280, 738).groups.find(({ group }) => group.panels.includes(id))!.rectangle.height;
    const grown = growPanel(layout, 'console', 340);
    expect(heightOf(grown, 'console')).toBe(340);
    expect(heightOf(grown, 'viewport')).toBe(738 - 340 - EDGE);
    expect(growPanel(grown, 'console', 100)).toEqual(grown);
    for (const id of ['inspector', 'hierarchy', 'viewport']) expect(growPanel(layout, id, 340)).toEqual(layout);
  });

  it('gives panels more of a large window, so that labels and pictures of assets fit', () => {
    const { groups } = placeLayout(defaultLayout(panels, 1440, 2560), 2560, 1380);
    const sizeOf = (id: string): number[] => {
      const { width, height } = groups.find(({ group }) => group.id === id)!.rectangle;
      return [width, height];
    };
    expect(sizeOf('left')[0]).toBe(333);
    expect(sizeOf('right')[0]).toBe(460);
    expect(sizeOf('bottom')[1]).toBe(317);
    expect(sizeOf('middle')[0]).toBeGreaterThan(1700);
  });

  it('gives the picture all the width of a tablet that is held upright', () => {
    const layout = defaultLayout(panels, 1180, 820);
    expectSound(layout, ['hierarchy', 'viewport', 'inspector', 'history', 'assets', 'console']);
    expect(groupsOf(layout).map((group) => group.panels)).toEqual([
      ['viewport'],
      ['hierarchy', 'assets', 'console'],
      ['inspector', 'history'],
    ]);
    const [picture] = placeLayout(layout, 820, 1060).groups;
    expect(picture.rectangle).toEqual({ x: 0, y: 0, width: 820, height: 1060 - 496 - EDGE });
    expect(groupsOf(defaultLayout(panels, 820, 1180))[0].panels).toEqual(['hierarchy']);
    // a panel opened later joins those with the same place
    const opened = openPanel(layout, { id: 'microshaders', place: 'bottom' }, panels);
    expect(groupWith(opened, 'microshaders')!.panels).toContain('assets');
  });

  it('stays sound under random moves, and fills the window without a gap', () => {
    const random = createRandom(7);
    const below = (count: number): number => Math.floor(random() * count);
    let layout = defaultLayout(panels);
    let ids = groupsOf(layout).flatMap((group) => group.panels);
    for (let i = 0; i < 2000; i++) {
      const panel = panels[below(panels.length)];
      const groups = groupsOf(layout);
      const act = below(5);
      if (act === 0 && ids.length > 1 && ids.includes(panel.id)) {
        layout = removePanel(layout, panel.id)!;
        ids = ids.filter((id) => id !== panel.id);
      } else if (act === 1) {
        layout = openPanel(layout, panel, panels);
        ids = [...new Set([...ids, panel.id])];
        expect(groupWith(layout, panel.id)!.active).toBe(panel.id);
      } else if (act === 2 && ids.includes(panel.id)) layout = activatePanel(layout, panel.id);
      else if (ids.includes(panel.id)) {
        const side = (['centre', 'left', 'right', 'top', 'bottom'] as const satisfies DropSide[])[below(5)];
        const group = groups[below(groups.length)];
        layout = movePanel(layout, panel.id, {
          group: group.id,
          side,
          index: below(group.panels.length + 1),
          extent: 300,
        });
      }
      expectSound(layout, ids);
      const [width, height] = [700 + below(900), 500 + below(500)];
      const { groups: placed, edges } = placeLayout(layout, width, height);
      const area = [...placed, ...edges].reduce((sum, { rectangle: r }) => sum + r.width * r.height, 0);
      expect(area).toBe(width * height);
      for (const { rectangle } of placed) expect(Math.min(rectangle.width, rectangle.height)).toBeGreaterThan(0);
      const edge = edges[below(edges.length)];
      if (edge) layout = resizeSplit(layout, edge.path, moveEdge(edge, (random() - 0.5) * 600));
    }
  });

  it('moves a tab within its group', () => {
    const layout = defaultLayout(panels);
    const moved = movePanel(layout, 'inspector', { group: 'right', side: 'centre', index: 2 });
    expect(groupWith(moved, 'inspector')!.panels).toEqual(['history', 'inspector']);
    expect(movePanel(layout, 'hierarchy', { group: 'left', side: 'bottom' })).toBe(layout);
  });

  it('takes what it knows of a stored layout, and nothing of a broken one', () => {
    const layout = defaultLayout(panels);
    const known = (id: string): boolean => id !== 'console' && id !== 'hierarchy';
    const repaired = repairLayout(JSON.parse(JSON.stringify(layout)), known)!;
    expect(groupsOf(repaired).map((group) => group.panels)).toEqual([
      ['viewport'],
      ['assets'],
      ['inspector', 'history'],
    ]);
    expect(repairLayout({ kind: 'split', direction: 'row', children: [layout], sizes: [1] }, () => true)).toBeNull();
    const twice = { kind: 'split', direction: 'row', children: [layout, layout], sizes: [1, 1] };
    expect(repairLayout(twice, () => true)).toBeNull();
    expect(repairLayout('left', () => true)).toBeNull();
  });
});
