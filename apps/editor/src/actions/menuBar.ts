import type { Action } from '../api/Action';

/** Puts the focus on the bar of menus, whose arrow keys go on from there. */
export const goToMenuBar: Action = {
  id: 'panels.menu-bar',
  label: 'Go to the menus',
  keys: ['F10'],
  inFields: true,
  menu: { menu: 'view', group: 'window', submenu: 'Go to' },
  run: () => document.querySelector<HTMLElement>('.menu-bar [role="menuitem"], button.menu-bar')?.focus(),
};
