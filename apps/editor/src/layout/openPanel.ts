import { activatePanel, beside, insertPanel } from './editLayout';
import { groupOfPlace, type PlacedPanel } from './defaultLayout';
import { groupsOf, groupWith, type LayoutNode, MAIN_PANEL } from './LayoutNode';

/**
 * Brings a panel to the front. A closed one is added to the group of panels with the same default place, else at its
 * side of the window.
 */
export function openPanel(layout: LayoutNode, panel: PlacedPanel, panels: readonly PlacedPanel[]): LayoutNode {
  const { id, place } = panel;
  if (groupWith(layout, id)) return activatePanel(layout, id);
  const like = groupsOf(layout).find(
    (group) =>
      group.id === groupOfPlace(place) ||
      group.panels.some((other) => panels.some((each) => each.id === other && each.place === place)),
  );
  if (like) return insertPanel(layout, id, { group: like.id, side: 'centre' });
  if (place === 'left' || place === 'right') {
    return beside(layout, { kind: 'group', id: groupOfPlace(place), panels: [id], active: id }, place, 900);
  }
  const main = groupWith(layout, MAIN_PANEL) ?? groupsOf(layout)[0];
  const side = place === 'bottom' ? 'bottom' : 'centre';
  return insertPanel(layout, id, { group: main.id, side, extent: 600 });
}
