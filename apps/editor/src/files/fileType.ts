import { t } from '@farol/editing';

/** The kind of file that the dialogs of open and save offer. */
export const fileType = {
  id: 'farol-scene',
  get description() {
    return t('Farol scene');
  },
  mimeTypes: ['application/x-farol'],
  extensions: ['.farol', '.json'],
};
