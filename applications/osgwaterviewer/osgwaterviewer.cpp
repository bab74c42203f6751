#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/CompileShaders>
#include <osgWaterReflect/TrochoidalWaves>
#include <osgViewer/Viewer>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osg/ShapeDrawable>
#include <osg/Timer>
#include <iostream>
#include "../../osgWaterReflect/offscreen/OffscreenContext.h"
using namespace osgWaterReflect;
int main(int argc,char**argv){
 int w=640,h=480; 
 osg::ref_ptr<osg::Group> root=new osg::Group;
 if(getenv("MODEL")) root->addChild(osgDB::readRefNodeFile(getenv("MODEL")));
 else { auto g=new osg::Geode; 
  for(int i=0;i<12;i++){ auto b=new osg::ShapeDrawable(new osg::Box(osg::Vec3(-12+i*2.3,8+(i*7%5)*4,1),1.2,1.2,2+i%3)); b->setColor(osg::Vec4((i%3)/2.0,(i%5)/4.0,(i%2),1)); g->addDrawable(b);} root->addChild(g);}
 auto water=WaterSurface::createRectangle(osg::Vec3(0,0,0),osg::Vec3(300,0,0),osg::Vec3(0,300,0));
 root->addChild(water);
 if(getenv("WAVES")) water->setWaves(TrochoidalWaves::createBreeze(2.0,atof(getenv("WAVES"))));
 if(getenv("DBG")) water->setDebugView((WaterSurface::DebugView)atoi(getenv("DBG")));
 if(getenv("BIN")) {ReflectionSettings s; s.search=Search::BINARY; water->setReflection(s);}
 auto gc=createOffscreenContext(w,h);
 osgViewer::Viewer v; v.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
 auto c=v.getCamera(); c->setGraphicsContext(gc); c->setViewport(0,0,w,h); c->setDrawBuffer(GL_FRONT);c->setReadBuffer(GL_FRONT);
 c->setProjectionMatrixAsPerspective(46,double(w)/h,.1,5000);
 c->setViewMatrixAsLookAt(osg::Vec3(0,-8,2.2),osg::Vec3(0,10,1),osg::Vec3(0,0,1));
 v.setSceneData(root); v.setRealizeOperation(new CompileShaders); v.realize();
 osg::ref_ptr<osg::Image> im=new osg::Image; im->allocateImage(w,h,1,GL_RGBA,GL_UNSIGNED_BYTE); c->attach(osg::Camera::COLOR_BUFFER,im);
 for(int i=0;i<4;i++){osg::Timer_t t=osg::Timer::instance()->tick(); v.frame(1.0+i*.0); std::cout<<osg::Timer::instance()->delta_m(t,osg::Timer::instance()->tick())<<" ms\n";}
 osgDB::writeImageFile(*im,argc>1?argv[1]:"/tmp/o.png");
}
