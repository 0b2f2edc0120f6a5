#pragma once

#include <string>
#include <vector>

#include <osg/ref_ptr>
#include <osgDB/Options>

namespace osg {
class Node;
}

namespace irsg {

/// While an object lives, OpenSceneGraph opens on this thread only what OpenableFiles lists, and
/// loads only the plug-ins for that: whoever asks, a plug-in inside a plug-in included. What it is
/// asked for beyond that is not opened and noted, and outside a reading process nothing is. What is
/// read elsewhere in the process, such as fonts, is not touched. Objects nest; each notes for
/// itself.
class GuardedReading {
  public:
    GuardedReading();
    ~GuardedReading();
    GuardedReading(const GuardedReading&) = delete;
    GuardedReading& operator=(const GuardedReading&) = delete;

    /// Options for a plug-in: without a cache, and with a guard that stays with whatever keeps a
    /// copy of them, on any thread.
    static osg::ref_ptr<osgDB::Options> options(const std::string& text = "");

    /// What was not opened so far and why, each once.
    std::vector<std::string> take();

  private:
    GuardedReading* outer_;
    std::vector<std::string> refused_;
    friend void noteRefusal(const std::string&);
};

/// Takes from a graph what reads files only later, when it is drawn or updated and no guard
/// watches: pages, streams of pictures and callbacks of scripts. Returns a remark for each.
std::vector<std::string> removeLateReaders(osg::Node& graph);

} // namespace irsg
