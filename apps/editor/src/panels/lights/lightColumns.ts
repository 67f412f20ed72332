import { t } from '@farol/editing';
import type { LightColumn } from '../../model/lights/LightTable';

interface Column {
  readonly id: LightColumn;
  readonly title: string;
  /** Explanation shown as a tooltip. */
  readonly help: string;
}

/** Columns of the table, in their order. */
export const lightColumns = (): readonly Column[] => [
  { id: 'on', title: t('On##column'), help: t('Whether the light is switched on.') },
  {
    id: 'solo',
    title: t('Solo'),
    help: t('Shows lights alone, until the scene plays or the panel is closed. Not saved.'),
  },
  { id: 'name', title: t('Name'), help: t('A click selects the object, a double click frames it.') },
  { id: 'kind', title: t('Kind'), help: t('How the light spreads.') },
  {
    id: 'colour',
    title: t('Colour'),
    help: t('Colour of the light, sorted by hue, and its temperature where it has one.'),
  },
  {
    id: 'intensity',
    title: t('Intensity'),
    help: t(
      'Drag to dim; press the number to type. Several selected rows are dimmed by one factor. A group has a percentage.',
    ),
  },
  { id: 'range', title: t('Range'), help: t('Distance where the light ends.') },
  { id: 'shadow', title: t('Shadow'), help: t('Whether objects cast shadows in it.') },
  {
    id: 'cost',
    title: t('Cost'),
    help: t(
      'Share of the lighting time, estimated for this view: tiles of 32 pixels that the bounds of the light touch, as in the lists of lights, times the cost of its kind (rectangle 4, disc 6.4, tube 3.7, ambient 0), twice that with a shadow. Walls that hide it do not count.',
    ),
  },
];
