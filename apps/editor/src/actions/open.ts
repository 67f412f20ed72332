import type { Action } from '../api/Action';
import { fileType } from '../files/fileType';

export const open: Action = {
  id: 'file.open',
  label: 'Open…',
  keys: ['Ctrl+O'],
  inFields: true,
  icon: 'open',
  menu: { menu: 'file', group: 'open' },
  async run(editor) {
    const { fileOpen } = await import('browser-fs-access');
    const file = await fileOpen(fileType);
    await editor.openFileBytes(new Uint8Array(await file.arrayBuffer()), {
      name: file.name,
      handle: file.handle ?? null,
    });
  },
};
