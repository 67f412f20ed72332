export { type Interception, type Interceptor, interceptRender } from './interceptRender';
