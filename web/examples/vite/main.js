import 'seamwise/element/auto';
