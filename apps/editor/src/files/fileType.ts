import { t } from '@farol/editing';

/** File type offered by open and save dialogs. */
export const fileType = {
  id: 'farol-scene',
  get description() {
    return t('Farol scene');
  },
  mimeTypes: ['application/x-farol'],
  extensions: ['.farol', '.json'],
};
