import type { Action } from '../api/Action';

/** Focuses the menu bar. */
export const goToMenuBar: Action = {
  id: 'panels.menu-bar',
  label: 'Go to the menus',
  keys: ['F10'],
  inFields: true,
  menu: { menu: 'view', group: 'window', submenu: 'Go to' },
  run: () => document.querySelector<HTMLElement>('.menu-bar [role="menuitem"], button.menu-bar')?.focus(),
};
