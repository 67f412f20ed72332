import { t } from '@farol/editing';

/** What the file dialogs of open and save offer. */
export const fileType = {
  id: 'farol-scene',
  get description() {
    return t('Farol scene');
  },
  mimeTypes: ['application/x-farol'],
  extensions: ['.farol', '.json'],
};
