import { t } from '@farol/editing';
import type { Action, MenuPlace } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { actionEntry, type MenuEntry } from '../api/MenuEntry';
import { allActions, menuBar } from '.';

export type MenuName = MenuPlace['menu'];

export const menuNames = Object.keys(menuBar) as readonly MenuName[];

export const menuLabel = (name: MenuName): string =>
  ({ file: t('File'), edit: t('Edit'), object: t('Object'), view: t('View'), help: t('Help') })[name];

/** Actions that are also in a second menu. */
const alsoIn: Readonly<Record<string, MenuPlace>> = { 'file.welcome': { menu: 'help', group: 'learn' } };

/** Menu and group of plugins' actions that name no place. */
const PLUGINS: MenuPlace = { menu: 'edit', group: 'plugins', submenu: 'Plugins' };

/** Groups items by key, in the order of first appearance. */
function groupsBy<T>(list: readonly T[], keyOf: (item: T) => string): Map<string, T[]> {
  const groups = new Map<string, T[]>();
  for (const item of list) {
    const key = keyOf(item);
    const group = groups.get(key);
    if (group) group.push(item);
    else groups.set(key, [item]);
  }
  return groups;
}

/** Entries of a menu: its actions in groups with separators, and submenus. */
export function menuEntries(editor: EditorApi, menu: MenuName): MenuEntry[] {
  const placed = allActions(editor)
    .flatMap((action) => {
      const places = [action.menu ?? PLUGINS, alsoIn[action.id]].filter((place) => place !== undefined);
      return places.map((place) => ({ action, place }));
    })
    .filter(({ place }) => place.menu === menu);
  const groups = groupsBy(placed, ({ place }) => place.group);
  const order = [...new Set([...Object.keys(menuBar[menu]), ...groups.keys()])];
  const entries: MenuEntry[] = [];
  for (const name of order) {
    const group = groups.get(name);
    if (!group) continue;
    if (entries.length > 0) entries.push('separator');
    const lines = groupsBy(group, ({ action, place }) => (place.submenu ? `/${place.submenu}` : action.id));
    for (const line of lines.values()) {
      const [{ action, place }] = line;
      if (place.submenu) entries.push(submenu(editor, t(place.submenu), line));
      else entries.push(actionEntry(action, editor));
    }
  }
  return entries;
}

const submenu = (editor: EditorApi, label: string, line: readonly { action: Action }[]): MenuEntry => ({
  label,
  entries: line.map(({ action }) => actionEntry(action, editor)),
});
