import { t } from '@farol/editing';
import { guides } from '@farol/tools/guides';
import type { PaletteItem } from './paletteItems';

/** Guides of the site, in English; each opens in a new window. */
export const guideItems = (): PaletteItem[] =>
  Object.entries(guides).flatMap(([group, pages]) =>
    Object.entries(pages).map(([file, name]): PaletteItem => ({
      id: `guide.${file}`,
      label: name,
      group: `${t('Guides')}, ${group}`,
      icon: 'eye',
      async run() {
        const { openBeside } = await import('../../files/readScene');
        return openBeside('gallery', t('Guides'), { path: `../guides/${file}.html` });
      },
    })),
  );
