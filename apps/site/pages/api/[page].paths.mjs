import { apiIndex, apiPage, apiPages } from '@farol/tools/site/api/apiPages';

/** Pages of the API, made of the sources. */
export default {
  paths: () => [
    { params: { page: 'index', title: 'API' }, content: apiIndex() },
    ...apiPages().pages.map((page) => ({ params: { page: page.name, title: page.title }, content: apiPage(page) })),
  ],
};
